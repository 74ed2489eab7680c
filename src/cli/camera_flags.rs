//! The camera flags.

use super::{CliError, value};
use crate::{
    camera::{CameraChoice, DepthMapping, Projection, SectionChoice, UpAxis, View, Viewport},
    geometry::Sides,
    scene::Loaded,
    viewer::model::{self, HideAndShow},
};
use glam::DVec3;

const DEPTHS: [(&str, DepthMapping); 2] = [
    ("reversed", DepthMapping::Reversed),
    ("standard", DepthMapping::Standard),
];
const UP_AXES: [(&str, UpAxis); 2] = [("y", UpAxis::Y), ("z", UpAxis::Z)];

/// The camera's flags. For each field, a flag has priority over the scene file's camera, which has priority over
/// automatic framing.
#[derive(Clone, Debug, Default, PartialEq, clap::Args)]
#[command(next_help_heading = "View")]
pub struct ViewArgs {
    /// Size of the picture, or of the window, in pixels [default: 1280x720]
    #[arg(long, value_name = "WxH", value_parser = value::size, allow_hyphen_values = true)]
    pub size: Option<Viewport>,
    /// Where the eye stands
    #[arg(long, value_name = "X,Y,Z", value_parser = value::vector, allow_hyphen_values = true)]
    pub eye: Option<DVec3>,
    /// The point that the eye looks at
    #[arg(long, value_name = "X,Y,Z", value_parser = value::vector, allow_hyphen_values = true)]
    pub target: Option<DVec3>,
    /// The direction that the eye looks in
    #[arg(long, value_name = "X,Y,Z", value_parser = value::vector, allow_hyphen_values = true)]
    #[arg(conflicts_with = "target")]
    pub look: Option<DVec3>,
    /// What is up in the picture
    #[arg(long, value_name = "X,Y,Z", value_parser = value::vector, allow_hyphen_values = true)]
    pub up: Option<DVec3>,
    /// Vertical field of view in degrees [default: 45]
    #[arg(long, value_name = "DEG", value_parser = value::number, allow_hyphen_values = true)]
    pub fov: Option<f64>,
    /// Orthographic, with this full height in world units
    #[arg(long, value_name = "HEIGHT", value_parser = value::number, allow_hyphen_values = true)]
    #[arg(conflicts_with = "fov")]
    pub ortho: Option<f64>,
    /// View depth of the near plane [default: fits the scene]
    #[arg(long, value_name = "N", value_parser = value::number, allow_hyphen_values = true)]
    pub near: Option<f64>,
    /// View depth of the far plane [default: fits the scene]
    #[arg(long, value_name = "F", value_parser = value::number, allow_hyphen_values = true)]
    pub far: Option<f64>,
    /// What the depth buffer stores [default: reversed]
    #[arg(long, value_name = "MAPPING", value_parser = value::word(DEPTHS))]
    pub depth: Option<DepthMapping>,
    /// Show and hit front faces only
    #[arg(long)]
    pub cull: bool,
    /// Which world axis points up [default: y]
    #[arg(long, value_name = "AXIS", value_parser = value::word(UP_AXES))]
    pub up_axis: Option<UpAxis>,
    /// Cut the world by a plane: what lies behind is not drawn, not picked
    ///
    /// NX,NY,NZ,C keeps the points p with N . p + C >= 0.
    /// x:0.5 keeps the points with x >= 0.5, and -x:0.5 those with x <= 0.5;
    /// y and z likewise.
    /// points:X,Y,Z/X,Y,Z/X,Y,Z keeps the side of the plane from which the
    /// three points are counter-clockwise.
    /// face:ID,TRIANGLE keeps what lies behind a triangle, numbered as in
    /// picks. For a cube, TRIANGLE is a face 0 to 5: +x, -x, +y, -y, +z, -z.
    /// For a square, write face:ID.
    /// The plane itself is kept. none ignores the section of a scene file.
    #[arg(long, value_name = "PLANE", allow_hyphen_values = true)]
    #[arg(verbatim_doc_comment)]
    pub section: Option<SectionChoice>,
    /// Hide objects: neither drawn nor picked
    #[arg(long, value_name = "ID,...", value_delimiter = ',', value_parser = value::id)]
    #[arg(allow_hyphen_values = true)]
    pub hide: Vec<usize>,
    /// Show objects that the scene file hides
    #[arg(long, value_name = "ID,...", value_delimiter = ',', value_parser = value::id)]
    #[arg(allow_hyphen_values = true)]
    pub show: Vec<usize>,
}

impl ViewArgs {
    /// What the flags say about the camera.
    pub fn choice(&self) -> CameraChoice {
        CameraChoice {
            eye: self.eye,
            target: self.target,
            look: self.look,
            up: self.up,
            fov: self.fov,
            ortho: self.ortho,
            near: self.near,
            far: self.far,
            depth: self.depth,
            up_axis: self.up_axis,
            section: self.section,
        }
    }

    /// What the flags say about which objects show.
    pub fn visibility(&self) -> HideAndShow {
        HideAndShow {
            hide: self.hide.clone(),
            show: self.show.clone(),
        }
    }

    /// The picture's size.
    pub fn size(&self) -> Viewport {
        self.size.unwrap_or(Viewport::DEFAULT)
    }

    /// Which sides of surfaces show.
    pub fn sides(&self) -> Sides {
        if self.cull { Sides::Front } else { Sides::Both }
    }

    /// Hides and shows the objects of `--hide` and `--show`, and returns the view of the scene. It is an error if an id names no
    /// object, or if flags and scene give no valid camera.
    pub fn apply(&self, loaded: &mut Loaded) -> Result<View, CliError> {
        let hidden = self.visibility().apply(&mut loaded.scene);
        hidden.map_err(CliError::usage)?;
        let flags = self.choice();
        let choice = flags.or(loaded.camera);
        let in_file = |what: String| {
            let (file, line) = loaded.camera_from.clone()?;
            Some(CliError::new(
                3,
                format!("{}:{line}: {what}", file.display()),
            ))
        };
        let camera = choice.resolve(&loaded.scene, self.size());
        let camera = camera.map_err(|error| {
            // Without a flag, the error can only come from the scene file.
            let is_in_file = flags == CameraChoice::default();
            let in_file = in_file(error.to_string()).filter(|_| is_in_file);
            in_file.unwrap_or_else(|| CliError::usage(format!("{error}; see --help")))
        })?;
        let section = loaded.scene.section(choice.section.unwrap_or_default());
        let section = section.map_err(|error| {
            let error = model::no_section(&error);
            let in_file = in_file(format!("section: {error}")).filter(|_| flags.section.is_none());
            in_file.unwrap_or_else(|| CliError::usage(format!("--section: {error}")))
        })?;
        let [eye, target, up] = [camera.eye(), camera.target(), camera.up_hint()]
            .map(|v| format!("{},{},{}", v.x, v.y, v.z));
        let lens = camera.lens();
        let extent = match lens.projection {
            Projection::Perspective { fov_y } => format!("--fov {}", model::degrees(fov_y)),
            Projection::Orthographic { height } => format!("--ortho {height}"),
        };
        log::info!(
            "camera: --eye {eye} --target {target} --up {up} {extent} --near {} --far {}",
            lens.near,
            lens.far
        );
        Ok(View {
            camera,
            viewport: self.size(),
            sides: self.sides(),
            section,
        })
    }
}
