# Print an optspec for argparse to handle cmd's options that are independent of any subcommand.
function __fish_sightline_global_optspecs
    string join \n v/verbose views= tour size= eye= target= look= up= fov= ortho= near= far= depth= cull up-axis= section= hide= show= h/help V/version
end

function __fish_sightline_needs_command
    # Figure out if the current invocation already has a command.
    set -l cmd (commandline -opc)
    set -e cmd[1]
    argparse -s (__fish_sightline_global_optspecs) -- $cmd 2>/dev/null
    or return
    if set -q argv[1]
        # Also print the command, so this can be used to figure out what it is.
        echo $argv[1]
        return 1
    end
    return 0
end

function __fish_sightline_using_subcommand
    set -l cmd (__fish_sightline_needs_command)
    test -z "$cmd"
    and return 1
    contains -- $cmd[1] $argv
end

complete -c sightline -n "__fish_sightline_needs_command" -l views -d 'What to show: the camera\'s picture, the four views side by side, or one of them [default: picture]' -r -f -a "picture\t''
four\t''
object\t''
world\t''
view\t''
ndc\t''"
complete -c sightline -n "__fish_sightline_needs_command" -l size -d 'Size of the picture, or of the window, in pixels [default: 1280x720]' -r
complete -c sightline -n "__fish_sightline_needs_command" -l eye -d 'Where the eye stands' -r
complete -c sightline -n "__fish_sightline_needs_command" -l target -d 'The point that the eye looks at' -r
complete -c sightline -n "__fish_sightline_needs_command" -l look -d 'The direction that the eye looks in' -r
complete -c sightline -n "__fish_sightline_needs_command" -l up -d 'What is up in the picture' -r
complete -c sightline -n "__fish_sightline_needs_command" -l fov -d 'Vertical field of view in degrees [default: 45]' -r
complete -c sightline -n "__fish_sightline_needs_command" -l ortho -d 'Orthographic, with this full height in world units' -r
complete -c sightline -n "__fish_sightline_needs_command" -l near -d 'View depth of the near plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_needs_command" -l far -d 'View depth of the far plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_needs_command" -l depth -d 'What the depth buffer stores [default: reversed]' -r -f -a "reversed\t''
standard\t''"
complete -c sightline -n "__fish_sightline_needs_command" -l up-axis -d 'Which world axis points up [default: y]' -r -f -a "y\t''
z\t''"
complete -c sightline -n "__fish_sightline_needs_command" -l section -d 'Cut the world by a plane: what lies behind is not drawn, not picked' -r
complete -c sightline -n "__fish_sightline_needs_command" -l hide -d 'Hide objects: neither drawn nor picked' -r
complete -c sightline -n "__fish_sightline_needs_command" -l show -d 'Show objects that the scene file hides' -r
complete -c sightline -n "__fish_sightline_needs_command" -s v -l verbose -d 'Say on stderr what is being done'
complete -c sightline -n "__fish_sightline_needs_command" -l tour -d 'Open the demo and begin the tour of cameras and raycasting'
complete -c sightline -n "__fish_sightline_needs_command" -l cull -d 'Show and hit front faces only'
complete -c sightline -n "__fish_sightline_needs_command" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c sightline -n "__fish_sightline_needs_command" -s V -l version -d 'Print version'
complete -c sightline -n "__fish_sightline_needs_command" -a "render" -d 'Draw the scene into a PNG file'
complete -c sightline -n "__fish_sightline_needs_command" -a "pick" -d 'Say what is at a position of the picture: one line of JSON for each pick'
complete -c sightline -n "__fish_sightline_needs_command" -a "list" -d 'List the objects: id, name, shape, triangles, bounds'
complete -c sightline -n "__fish_sightline_needs_command" -a "study" -d 'Measure how fast and how right the known methods are'
complete -c sightline -n "__fish_sightline_needs_command" -a "verify" -d 'Compare what is drawn with what is picked, pixel by pixel'
complete -c sightline -n "__fish_sightline_needs_command" -a "doctor" -d 'Say what this machine draws with and what its adapters can do: the text for a bug report'
complete -c sightline -n "__fish_sightline_needs_command" -a "completions" -d 'Print what makes a shell complete commands and flags'
complete -c sightline -n "__fish_sightline_needs_command" -a "help" -d 'Print this message or the help of the given subcommand(s)'
complete -c sightline -n "__fish_sightline_using_subcommand render" -s o -l output -d 'The PNG file to write; - writes it to standard output' -r -F
complete -c sightline -n "__fish_sightline_using_subcommand render" -l by -d 'What draws: the graphics adapter, or rays on the CPU [default: the adapter; rays where none draws]' -r -f -a "raster\t'The graphics adapter'
raycast\t'One ray per pixel, on the CPU'"
complete -c sightline -n "__fish_sightline_using_subcommand render" -l pick -d 'Draw the object at this position as selected' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l ids -d 'Also write object ids, as 16-bit grey: 0 for the background, n for the object with id n' -r -F
complete -c sightline -n "__fish_sightline_using_subcommand render" -l views -d 'Draw the four views side by side, or one of them, as the window does, with a graphics adapter [default: picture]' -r -f -a "picture\t''
four\t''
object\t''
world\t''
view\t''
ndc\t''"
complete -c sightline -n "__fish_sightline_using_subcommand render" -l background -d 'What is behind the scene' -r -f -a "dark\t''
light\t''
white\t''
transparent\t''"
complete -c sightline -n "__fish_sightline_using_subcommand render" -l size -d 'Size of the picture, or of the window, in pixels [default: 1280x720]' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l eye -d 'Where the eye stands' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l target -d 'The point that the eye looks at' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l look -d 'The direction that the eye looks in' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l up -d 'What is up in the picture' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l fov -d 'Vertical field of view in degrees [default: 45]' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l ortho -d 'Orthographic, with this full height in world units' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l near -d 'View depth of the near plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l far -d 'View depth of the far plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l depth -d 'What the depth buffer stores [default: reversed]' -r -f -a "reversed\t''
standard\t''"
complete -c sightline -n "__fish_sightline_using_subcommand render" -l up-axis -d 'Which world axis points up [default: y]' -r -f -a "y\t''
z\t''"
complete -c sightline -n "__fish_sightline_using_subcommand render" -l section -d 'Cut the world by a plane: what lies behind is not drawn, not picked' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l hide -d 'Hide objects: neither drawn nor picked' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -l show -d 'Show objects that the scene file hides' -r
complete -c sightline -n "__fish_sightline_using_subcommand render" -s v -l verbose -d 'Say on stderr what is being done'
complete -c sightline -n "__fish_sightline_using_subcommand render" -l cull -d 'Show and hit front faces only'
complete -c sightline -n "__fish_sightline_using_subcommand render" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l at -d 'Where to pick, in pixels from the top left; - reads lines of X,Y' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l snap -d 'Move each position to what is nearest within R pixels, and measure' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l size -d 'Size of the picture, or of the window, in pixels [default: 1280x720]' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l eye -d 'Where the eye stands' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l target -d 'The point that the eye looks at' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l look -d 'The direction that the eye looks in' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l up -d 'What is up in the picture' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l fov -d 'Vertical field of view in degrees [default: 45]' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l ortho -d 'Orthographic, with this full height in world units' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l near -d 'View depth of the near plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l far -d 'View depth of the far plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l depth -d 'What the depth buffer stores [default: reversed]' -r -f -a "reversed\t''
standard\t''"
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l up-axis -d 'Which world axis points up [default: y]' -r -f -a "y\t''
z\t''"
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l section -d 'Cut the world by a plane: what lies behind is not drawn, not picked' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l hide -d 'Hide objects: neither drawn nor picked' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l show -d 'Show objects that the scene file hides' -r
complete -c sightline -n "__fish_sightline_using_subcommand pick" -s v -l verbose -d 'Say on stderr what is being done'
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l all-hits -d 'Give every surface along the ray, from front to back'
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l stored -d 'Print first, as a line of JSON, the numbers that picks are made of'
complete -c sightline -n "__fish_sightline_using_subcommand pick" -l cull -d 'Show and hit front faces only'
complete -c sightline -n "__fish_sightline_using_subcommand pick" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c sightline -n "__fish_sightline_using_subcommand list" -s v -l verbose -d 'Say on stderr what is being done'
complete -c sightline -n "__fish_sightline_using_subcommand list" -l json -d 'Print one line of JSON for each object, with all digits'
complete -c sightline -n "__fish_sightline_using_subcommand list" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c sightline -n "__fish_sightline_using_subcommand study" -s o -l out -d 'A folder for study.csv, summary.csv and the charts; created if missing' -r -F
complete -c sightline -n "__fish_sightline_using_subcommand study" -l seed -d 'The seed of the random numbers; the same seed gives the same verdicts on every machine' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l budget -d 'Instead of the study, say which is the simplest way to pick in SCENE within PX pixels' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l size -d 'Size of the picture, or of the window, in pixels [default: 1280x720]' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l eye -d 'Where the eye stands' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l target -d 'The point that the eye looks at' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l look -d 'The direction that the eye looks in' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l up -d 'What is up in the picture' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l fov -d 'Vertical field of view in degrees [default: 45]' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l ortho -d 'Orthographic, with this full height in world units' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l near -d 'View depth of the near plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l far -d 'View depth of the far plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l depth -d 'What the depth buffer stores [default: reversed]' -r -f -a "reversed\t''
standard\t''"
complete -c sightline -n "__fish_sightline_using_subcommand study" -l up-axis -d 'Which world axis points up [default: y]' -r -f -a "y\t''
z\t''"
complete -c sightline -n "__fish_sightline_using_subcommand study" -l section -d 'Cut the world by a plane: what lies behind is not drawn, not picked' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l hide -d 'Hide objects: neither drawn nor picked' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -l show -d 'Show objects that the scene file hides' -r
complete -c sightline -n "__fish_sightline_using_subcommand study" -s v -l verbose -d 'Say on stderr what is being done'
complete -c sightline -n "__fish_sightline_using_subcommand study" -l quick -d 'Run fewer cases and rounds: quicker, but less accurate'
complete -c sightline -n "__fish_sightline_using_subcommand study" -l cull -d 'Show and hit front faces only'
complete -c sightline -n "__fish_sightline_using_subcommand study" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l image -d 'Write the picture in grey; pixels that differ have a colour and a dark rim, pixels in one place a tint' -r -F
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l picker -d 'The method that picks: the program\'s own, or the usual one for comparison' -r -f -a "exact\t'The program\'s own picks, the same as on a click'
usual\t'In f32: rays from the inverse of Projection * View, tested by Moeller-Trumbore'"
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l size -d 'Size of the picture, or of the window, in pixels [default: 1280x720]' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l eye -d 'Where the eye stands' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l target -d 'The point that the eye looks at' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l look -d 'The direction that the eye looks in' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l up -d 'What is up in the picture' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l fov -d 'Vertical field of view in degrees [default: 45]' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l ortho -d 'Orthographic, with this full height in world units' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l near -d 'View depth of the near plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l far -d 'View depth of the far plane [default: fits the scene]' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l depth -d 'What the depth buffer stores [default: reversed]' -r -f -a "reversed\t''
standard\t''"
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l up-axis -d 'Which world axis points up [default: y]' -r -f -a "y\t''
z\t''"
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l section -d 'Cut the world by a plane: what lies behind is not drawn, not picked' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l hide -d 'Hide objects: neither drawn nor picked' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l show -d 'Show objects that the scene file hides' -r
complete -c sightline -n "__fish_sightline_using_subcommand verify" -s v -l verbose -d 'Say on stderr what is being done'
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l json -d 'Print one line of JSON instead of the table'
complete -c sightline -n "__fish_sightline_using_subcommand verify" -l cull -d 'Show and hit front faces only'
complete -c sightline -n "__fish_sightline_using_subcommand verify" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c sightline -n "__fish_sightline_using_subcommand doctor" -s v -l verbose -d 'Say on stderr what is being done'
complete -c sightline -n "__fish_sightline_using_subcommand doctor" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c sightline -n "__fish_sightline_using_subcommand completions" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c sightline -n "__fish_sightline_using_subcommand help; and not __fish_seen_subcommand_from render pick list study verify doctor completions help" -f -a "render" -d 'Draw the scene into a PNG file'
complete -c sightline -n "__fish_sightline_using_subcommand help; and not __fish_seen_subcommand_from render pick list study verify doctor completions help" -f -a "pick" -d 'Say what is at a position of the picture: one line of JSON for each pick'
complete -c sightline -n "__fish_sightline_using_subcommand help; and not __fish_seen_subcommand_from render pick list study verify doctor completions help" -f -a "list" -d 'List the objects: id, name, shape, triangles, bounds'
complete -c sightline -n "__fish_sightline_using_subcommand help; and not __fish_seen_subcommand_from render pick list study verify doctor completions help" -f -a "study" -d 'Measure how fast and how right the known methods are'
complete -c sightline -n "__fish_sightline_using_subcommand help; and not __fish_seen_subcommand_from render pick list study verify doctor completions help" -f -a "verify" -d 'Compare what is drawn with what is picked, pixel by pixel'
complete -c sightline -n "__fish_sightline_using_subcommand help; and not __fish_seen_subcommand_from render pick list study verify doctor completions help" -f -a "doctor" -d 'Say what this machine draws with and what its adapters can do: the text for a bug report'
complete -c sightline -n "__fish_sightline_using_subcommand help; and not __fish_seen_subcommand_from render pick list study verify doctor completions help" -f -a "completions" -d 'Print what makes a shell complete commands and flags'
complete -c sightline -n "__fish_sightline_using_subcommand help; and not __fish_seen_subcommand_from render pick list study verify doctor completions help" -f -a "help" -d 'Print this message or the help of the given subcommand(s)'
