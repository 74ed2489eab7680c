#compdef sightline

autoload -U is-at-least

_sightline() {
    typeset -A opt_args
    typeset -a _arguments_options
    local ret=1

    if is-at-least 5.2; then
        _arguments_options=(-s -S -C)
    else
        _arguments_options=(-s -C)
    fi

    local context curcontext="$curcontext" state line
    _arguments "${_arguments_options[@]}" : \
'--views=[What to show\: the camera'\''s picture, the four views side by side, or one of them \[default\: picture\]]:VIEWS:(picture four object world view ndc)' \
'--size=[Size of the picture, or of the window, in pixels \[default\: 1280x720\]]:WxH:_default' \
'--eye=[Where the eye stands]:X,Y,Z:_default' \
'--target=[The point that the eye looks at]:X,Y,Z:_default' \
'(--target)--look=[The direction that the eye looks in]:X,Y,Z:_default' \
'--up=[What is up in the picture]:X,Y,Z:_default' \
'--fov=[Vertical field of view in degrees \[default\: 45\]]:DEG:_default' \
'(--fov)--ortho=[Orthographic, with this full height in world units]:HEIGHT:_default' \
'--near=[View depth of the near plane \[default\: fits the scene\]]:N:_default' \
'--far=[View depth of the far plane \[default\: fits the scene\]]:F:_default' \
'--depth=[What the depth buffer stores \[default\: reversed\]]:MAPPING:(reversed standard)' \
'--up-axis=[Which world axis points up \[default\: y\]]:AXIS:(y z)' \
'--section=[Cut the world by a plane\: what lies behind is not drawn, not picked]:PLANE:_default' \
'*--hide=[Hide objects\: neither drawn nor picked]:ID,...:_default' \
'*--show=[Show objects that the scene file hides]:ID,...:_default' \
'-v[Say on stderr what is being done]' \
'--verbose[Say on stderr what is being done]' \
'()--tour[Open the demo and begin the tour of cameras and raycasting]' \
'--cull[Show and hit front faces only]' \
'-h[Print help (see more with '\''--help'\'')]' \
'--help[Print help (see more with '\''--help'\'')]' \
'-V[Print version]' \
'--version[Print version]' \
'::scenes -- .obj or .toml files, or gallery\:NAME; ids run on \[default\: the demo\]:_files' \
":: :_sightline_commands" \
"*::: :->sightline" \
&& ret=0
    case $state in
    (sightline)
        words=($line[2] "${words[@]}")
        (( CURRENT += 1 ))
        curcontext="${curcontext%:*:*}:sightline-command-$line[2]:"
        case $line[2] in
            (render)
_arguments "${_arguments_options[@]}" : \
'-o+[The PNG file to write; - writes it to standard output]:FILE.png:_files' \
'--output=[The PNG file to write; - writes it to standard output]:FILE.png:_files' \
'--by=[What draws\: the graphics adapter, or rays on the CPU \[default\: the adapter; rays where none draws\]]:BY:((raster\:"The graphics adapter"
raycast\:"One ray per pixel, on the CPU"))' \
'--pick=[Draw the object at this position as selected]:X,Y:_default' \
'--ids=[Also write object ids, as 16-bit grey\: 0 for the background, n for the object with id n]:FILE.png:_files' \
'(--ids --by)--views=[Draw the four views side by side, or one of them, as the window does, with a graphics adapter \[default\: picture\]]:VIEWS:(picture four object world view ndc)' \
'--background=[What is behind the scene]:BACKGROUND:(dark light white transparent)' \
'--size=[Size of the picture, or of the window, in pixels \[default\: 1280x720\]]:WxH:_default' \
'--eye=[Where the eye stands]:X,Y,Z:_default' \
'--target=[The point that the eye looks at]:X,Y,Z:_default' \
'(--target)--look=[The direction that the eye looks in]:X,Y,Z:_default' \
'--up=[What is up in the picture]:X,Y,Z:_default' \
'--fov=[Vertical field of view in degrees \[default\: 45\]]:DEG:_default' \
'(--fov)--ortho=[Orthographic, with this full height in world units]:HEIGHT:_default' \
'--near=[View depth of the near plane \[default\: fits the scene\]]:N:_default' \
'--far=[View depth of the far plane \[default\: fits the scene\]]:F:_default' \
'--depth=[What the depth buffer stores \[default\: reversed\]]:MAPPING:(reversed standard)' \
'--up-axis=[Which world axis points up \[default\: y\]]:AXIS:(y z)' \
'--section=[Cut the world by a plane\: what lies behind is not drawn, not picked]:PLANE:_default' \
'*--hide=[Hide objects\: neither drawn nor picked]:ID,...:_default' \
'*--show=[Show objects that the scene file hides]:ID,...:_default' \
'-v[Say on stderr what is being done]' \
'--verbose[Say on stderr what is being done]' \
'--cull[Show and hit front faces only]' \
'-h[Print help (see more with '\''--help'\'')]' \
'--help[Print help (see more with '\''--help'\'')]' \
'*::scenes -- .obj or .toml files, or gallery\:NAME; ids run on \[default\: the demo\]:_files' \
&& ret=0
;;
(pick)
_arguments "${_arguments_options[@]}" : \
'*--at=[Where to pick, in pixels from the top left; - reads lines of X,Y]:X,Y:_default' \
'(--all-hits)--snap=[Move each position to what is nearest within R pixels, and measure]:R:_default' \
'--size=[Size of the picture, or of the window, in pixels \[default\: 1280x720\]]:WxH:_default' \
'--eye=[Where the eye stands]:X,Y,Z:_default' \
'--target=[The point that the eye looks at]:X,Y,Z:_default' \
'(--target)--look=[The direction that the eye looks in]:X,Y,Z:_default' \
'--up=[What is up in the picture]:X,Y,Z:_default' \
'--fov=[Vertical field of view in degrees \[default\: 45\]]:DEG:_default' \
'(--fov)--ortho=[Orthographic, with this full height in world units]:HEIGHT:_default' \
'--near=[View depth of the near plane \[default\: fits the scene\]]:N:_default' \
'--far=[View depth of the far plane \[default\: fits the scene\]]:F:_default' \
'--depth=[What the depth buffer stores \[default\: reversed\]]:MAPPING:(reversed standard)' \
'--up-axis=[Which world axis points up \[default\: y\]]:AXIS:(y z)' \
'--section=[Cut the world by a plane\: what lies behind is not drawn, not picked]:PLANE:_default' \
'*--hide=[Hide objects\: neither drawn nor picked]:ID,...:_default' \
'*--show=[Show objects that the scene file hides]:ID,...:_default' \
'-v[Say on stderr what is being done]' \
'--verbose[Say on stderr what is being done]' \
'--all-hits[Give every surface along the ray, from front to back]' \
'--stored[Print first, as a line of JSON, the numbers that picks are made of]' \
'--cull[Show and hit front faces only]' \
'-h[Print help (see more with '\''--help'\'')]' \
'--help[Print help (see more with '\''--help'\'')]' \
'*::scenes -- .obj or .toml files, or gallery\:NAME; ids run on \[default\: the demo\]:_files' \
&& ret=0
;;
(list)
_arguments "${_arguments_options[@]}" : \
'-v[Say on stderr what is being done]' \
'--verbose[Say on stderr what is being done]' \
'--json[Print one line of JSON for each object, with all digits]' \
'-h[Print help (see more with '\''--help'\'')]' \
'--help[Print help (see more with '\''--help'\'')]' \
'*::scenes -- .obj or .toml files, or gallery\:NAME; ids run on \[default\: the demo\]:_files' \
&& ret=0
;;
(study)
_arguments "${_arguments_options[@]}" : \
'-o+[A folder for study.csv, summary.csv and the charts; created if missing]:DIR:_files' \
'--out=[A folder for study.csv, summary.csv and the charts; created if missing]:DIR:_files' \
'--seed=[The seed of the random numbers; the same seed gives the same verdicts on every machine]:N:_default' \
'(-o --out --quick)--budget=[Instead of the study, say which is the simplest way to pick in SCENE within PX pixels]:PX:_default' \
'--size=[Size of the picture, or of the window, in pixels \[default\: 1280x720\]]:WxH:_default' \
'--eye=[Where the eye stands]:X,Y,Z:_default' \
'--target=[The point that the eye looks at]:X,Y,Z:_default' \
'(--target)--look=[The direction that the eye looks in]:X,Y,Z:_default' \
'--up=[What is up in the picture]:X,Y,Z:_default' \
'--fov=[Vertical field of view in degrees \[default\: 45\]]:DEG:_default' \
'(--fov)--ortho=[Orthographic, with this full height in world units]:HEIGHT:_default' \
'--near=[View depth of the near plane \[default\: fits the scene\]]:N:_default' \
'--far=[View depth of the far plane \[default\: fits the scene\]]:F:_default' \
'--depth=[What the depth buffer stores \[default\: reversed\]]:MAPPING:(reversed standard)' \
'--up-axis=[Which world axis points up \[default\: y\]]:AXIS:(y z)' \
'--section=[Cut the world by a plane\: what lies behind is not drawn, not picked]:PLANE:_default' \
'*--hide=[Hide objects\: neither drawn nor picked]:ID,...:_default' \
'*--show=[Show objects that the scene file hides]:ID,...:_default' \
'-v[Say on stderr what is being done]' \
'--verbose[Say on stderr what is being done]' \
'--quick[Run fewer cases and rounds\: quicker, but less accurate]' \
'--cull[Show and hit front faces only]' \
'-h[Print help (see more with '\''--help'\'')]' \
'--help[Print help (see more with '\''--help'\'')]' \
'*::scenes -- .obj or .toml files, or gallery\:NAME; ids run on \[default\: the demo\]:_files' \
&& ret=0
;;
(verify)
_arguments "${_arguments_options[@]}" : \
'--image=[Write the picture in grey; pixels that differ have a colour and a dark rim, pixels in one place a tint]:FILE.png:_files' \
'--picker=[The method that picks\: the program'\''s own, or the usual one for comparison]:PICKER:((exact\:"The program'\''s own picks, the same as on a click"
usual\:"In f32\: rays from the inverse of Projection * View, tested by Moeller-Trumbore"))' \
'--size=[Size of the picture, or of the window, in pixels \[default\: 1280x720\]]:WxH:_default' \
'--eye=[Where the eye stands]:X,Y,Z:_default' \
'--target=[The point that the eye looks at]:X,Y,Z:_default' \
'(--target)--look=[The direction that the eye looks in]:X,Y,Z:_default' \
'--up=[What is up in the picture]:X,Y,Z:_default' \
'--fov=[Vertical field of view in degrees \[default\: 45\]]:DEG:_default' \
'(--fov)--ortho=[Orthographic, with this full height in world units]:HEIGHT:_default' \
'--near=[View depth of the near plane \[default\: fits the scene\]]:N:_default' \
'--far=[View depth of the far plane \[default\: fits the scene\]]:F:_default' \
'--depth=[What the depth buffer stores \[default\: reversed\]]:MAPPING:(reversed standard)' \
'--up-axis=[Which world axis points up \[default\: y\]]:AXIS:(y z)' \
'--section=[Cut the world by a plane\: what lies behind is not drawn, not picked]:PLANE:_default' \
'*--hide=[Hide objects\: neither drawn nor picked]:ID,...:_default' \
'*--show=[Show objects that the scene file hides]:ID,...:_default' \
'-v[Say on stderr what is being done]' \
'--verbose[Say on stderr what is being done]' \
'--json[Print one line of JSON instead of the table]' \
'--cull[Show and hit front faces only]' \
'-h[Print help (see more with '\''--help'\'')]' \
'--help[Print help (see more with '\''--help'\'')]' \
'*::scenes -- .obj or .toml files, or gallery\:NAME; ids run on \[default\: the demo\]:_files' \
&& ret=0
;;
(doctor)
_arguments "${_arguments_options[@]}" : \
'-v[Say on stderr what is being done]' \
'--verbose[Say on stderr what is being done]' \
'-h[Print help (see more with '\''--help'\'')]' \
'--help[Print help (see more with '\''--help'\'')]' \
&& ret=0
;;
(completions)
_arguments "${_arguments_options[@]}" : \
'-h[Print help (see more with '\''--help'\'')]' \
'--help[Print help (see more with '\''--help'\'')]' \
':shell -- The shell:(bash elvish fish powershell zsh)' \
&& ret=0
;;
(help)
_arguments "${_arguments_options[@]}" : \
":: :_sightline__subcmd__help_commands" \
"*::: :->help" \
&& ret=0

    case $state in
    (help)
        words=($line[1] "${words[@]}")
        (( CURRENT += 1 ))
        curcontext="${curcontext%:*:*}:sightline-help-command-$line[1]:"
        case $line[1] in
            (render)
_arguments "${_arguments_options[@]}" : \
&& ret=0
;;
(pick)
_arguments "${_arguments_options[@]}" : \
&& ret=0
;;
(list)
_arguments "${_arguments_options[@]}" : \
&& ret=0
;;
(study)
_arguments "${_arguments_options[@]}" : \
&& ret=0
;;
(verify)
_arguments "${_arguments_options[@]}" : \
&& ret=0
;;
(doctor)
_arguments "${_arguments_options[@]}" : \
&& ret=0
;;
(completions)
_arguments "${_arguments_options[@]}" : \
&& ret=0
;;
(help)
_arguments "${_arguments_options[@]}" : \
&& ret=0
;;
        esac
    ;;
esac
;;
        esac
    ;;
esac
}

(( $+functions[_sightline_commands] )) ||
_sightline_commands() {
    local commands; commands=(
'render:Draw the scene into a PNG file' \
'pick:Say what is at a position of the picture\: one line of JSON for each pick' \
'list:List the objects\: id, name, shape, triangles, bounds' \
'study:Measure how fast and how right the known methods are' \
'verify:Compare what is drawn with what is picked, pixel by pixel' \
'doctor:Say what this machine draws with and what its adapters can do\: the text for a bug report' \
'completions:Print what makes a shell complete commands and flags' \
'help:Print this message or the help of the given subcommand(s)' \
    )
    _describe -t commands 'sightline commands' commands "$@"
}
(( $+functions[_sightline__subcmd__completions_commands] )) ||
_sightline__subcmd__completions_commands() {
    local commands; commands=()
    _describe -t commands 'sightline completions commands' commands "$@"
}
(( $+functions[_sightline__subcmd__doctor_commands] )) ||
_sightline__subcmd__doctor_commands() {
    local commands; commands=()
    _describe -t commands 'sightline doctor commands' commands "$@"
}
(( $+functions[_sightline__subcmd__help_commands] )) ||
_sightline__subcmd__help_commands() {
    local commands; commands=(
'render:Draw the scene into a PNG file' \
'pick:Say what is at a position of the picture\: one line of JSON for each pick' \
'list:List the objects\: id, name, shape, triangles, bounds' \
'study:Measure how fast and how right the known methods are' \
'verify:Compare what is drawn with what is picked, pixel by pixel' \
'doctor:Say what this machine draws with and what its adapters can do\: the text for a bug report' \
'completions:Print what makes a shell complete commands and flags' \
'help:Print this message or the help of the given subcommand(s)' \
    )
    _describe -t commands 'sightline help commands' commands "$@"
}
(( $+functions[_sightline__subcmd__help__subcmd__completions_commands] )) ||
_sightline__subcmd__help__subcmd__completions_commands() {
    local commands; commands=()
    _describe -t commands 'sightline help completions commands' commands "$@"
}
(( $+functions[_sightline__subcmd__help__subcmd__doctor_commands] )) ||
_sightline__subcmd__help__subcmd__doctor_commands() {
    local commands; commands=()
    _describe -t commands 'sightline help doctor commands' commands "$@"
}
(( $+functions[_sightline__subcmd__help__subcmd__help_commands] )) ||
_sightline__subcmd__help__subcmd__help_commands() {
    local commands; commands=()
    _describe -t commands 'sightline help help commands' commands "$@"
}
(( $+functions[_sightline__subcmd__help__subcmd__list_commands] )) ||
_sightline__subcmd__help__subcmd__list_commands() {
    local commands; commands=()
    _describe -t commands 'sightline help list commands' commands "$@"
}
(( $+functions[_sightline__subcmd__help__subcmd__pick_commands] )) ||
_sightline__subcmd__help__subcmd__pick_commands() {
    local commands; commands=()
    _describe -t commands 'sightline help pick commands' commands "$@"
}
(( $+functions[_sightline__subcmd__help__subcmd__render_commands] )) ||
_sightline__subcmd__help__subcmd__render_commands() {
    local commands; commands=()
    _describe -t commands 'sightline help render commands' commands "$@"
}
(( $+functions[_sightline__subcmd__help__subcmd__study_commands] )) ||
_sightline__subcmd__help__subcmd__study_commands() {
    local commands; commands=()
    _describe -t commands 'sightline help study commands' commands "$@"
}
(( $+functions[_sightline__subcmd__help__subcmd__verify_commands] )) ||
_sightline__subcmd__help__subcmd__verify_commands() {
    local commands; commands=()
    _describe -t commands 'sightline help verify commands' commands "$@"
}
(( $+functions[_sightline__subcmd__list_commands] )) ||
_sightline__subcmd__list_commands() {
    local commands; commands=()
    _describe -t commands 'sightline list commands' commands "$@"
}
(( $+functions[_sightline__subcmd__pick_commands] )) ||
_sightline__subcmd__pick_commands() {
    local commands; commands=()
    _describe -t commands 'sightline pick commands' commands "$@"
}
(( $+functions[_sightline__subcmd__render_commands] )) ||
_sightline__subcmd__render_commands() {
    local commands; commands=()
    _describe -t commands 'sightline render commands' commands "$@"
}
(( $+functions[_sightline__subcmd__study_commands] )) ||
_sightline__subcmd__study_commands() {
    local commands; commands=()
    _describe -t commands 'sightline study commands' commands "$@"
}
(( $+functions[_sightline__subcmd__verify_commands] )) ||
_sightline__subcmd__verify_commands() {
    local commands; commands=()
    _describe -t commands 'sightline verify commands' commands "$@"
}

if [ "$funcstack[1]" = "_sightline" ]; then
    _sightline "$@"
else
    compdef _sightline sightline
fi
