//! Uploads a scene to graphics memory in the background.

use super::job::Job;
use crate::{
    geometry::shares::GoOn,
    render::{Gpu, GpuError, MeshStore, SceneBuffers},
    scene::{Cancelled, Progress, Scene, SceneKey},
    viewer::model::Made,
};

/// The scene to upload, and how it is made.
pub(in crate::viewer) enum Making {
    /// A scene as it is.
    Scene(Scene),
    /// A scene, with the objects of another after its own.
    With(Scene, Scene),
    /// A scene, and what its files hold now.
    Again(Scene, Scene),
}

impl Making {
    /// Objects and triangles in all.
    pub fn size(&self) -> usize {
        match self {
            Self::Scene(scene) => scene.size(),
            Self::With(scene, other) | Self::Again(scene, other) => scene.size() + other.size(),
        }
    }

    fn make<E>(self, go_on: &GoOn<E>) -> Result<(Scene, Option<Made>), E> {
        let made = match self {
            Self::Scene(scene) => return Ok((scene, None)),
            Self::With(scene, added) => Made::with_while(&scene, &added, go_on)?,
            Self::Again(scene, now) => Made::again(&scene, now),
        };
        Ok((made.scene.clone(), Some(made)))
    }
}

/// Why a scene is not in graphics memory.
#[derive(thiserror::Error, Debug)]
enum NotUploaded {
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

/// A scene in graphics memory.
pub(in crate::viewer) struct Uploaded {
    pub key: SceneKey,
    pub buffers: SceneBuffers,
    /// The scene's meshes and earlier ones.
    pub meshes: MeshStore,
    /// The scene, if the job made it.
    pub made: Option<Made>,
}

impl Uploaded {
    /// Uploads a scene, but not the meshes that are there already.
    pub fn new(gpu: &Gpu, scene: &Scene, meshes: MeshStore) -> Result<Self, GpuError> {
        Self::new_while(gpu, (scene, None), meshes, &|_| Ok(()))
    }

    fn new_while<E: From<GpuError> + Send>(
        gpu: &Gpu,
        (scene, made): (&Scene, Option<Made>),
        mut meshes: MeshStore,
        go_on: &GoOn<E>,
    ) -> Result<Self, E> {
        let buffers = SceneBuffers::upload_while(gpu, scene, &mut meshes, go_on)?;
        Ok(Self {
            key: scene.key(),
            buffers,
            meshes,
            made,
        })
    }
}

/// An upload under way. Dropping it cancels it.
pub(in crate::viewer) struct Upload {
    gpu: Gpu,
    job: Job<Result<Uploaded, NotUploaded>>,
}

impl Upload {
    /// Begins; `meshes` are on the device already. Calls `wake` when done.
    pub fn start(
        gpu: Gpu,
        making: Making,
        meshes: MeshStore,
        wake: impl FnOnce() + Send + 'static,
    ) -> Self {
        let device = gpu.clone();
        let work = move |progress: &Progress| upload(&device, making, meshes, progress);
        let lost = || Err(NotUploaded::Cancelled(Cancelled));
        let job = Job::start(work, wake, lost);
        Self { gpu, job }
    }

    /// The share that is done, in [0, 1].
    pub fn fraction(&self) -> f32 {
        self.job.fraction()
    }

    /// The outcome, once there is one: `Ok(None)` if the device was lost, which the next frame finds out too.
    pub fn poll(&self) -> Option<Result<Option<Uploaded>, GpuError>> {
        Some(match self.job.poll()? {
            Ok(uploaded) if !self.gpu.is_lost() => Ok(Some(uploaded)),
            Err(NotUploaded::Gpu(error)) if !self.gpu.is_lost() => Err(error),
            _ => Ok(None),
        })
    }
}

/// Makes a scene and uploads it, but not the meshes that are there already.
fn upload(
    gpu: &Gpu,
    making: Making,
    meshes: MeshStore,
    progress: &Progress,
) -> Result<Uploaded, NotUploaded> {
    let work = making.size() as u64;
    let made_of = work / 8;
    progress.expect(work);
    let (scene, made) =
        progress.in_shares::<_, NotUploaded>(made_of, |go_on| Ok(making.make(go_on)?))?;
    progress.in_shares(work - made_of, |go_on| {
        Uploaded::new_while(gpu, (&scene, made), meshes, &|share| Ok(go_on(share)?))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        geometry::{ColourRun, Mesh, MeshData, Placement},
        scene::{Object, Shape},
    };
    use std::sync::{Arc, atomic::Ordering::Relaxed};

    /// Triangles of each mesh: in several pieces, and in several buffers' pieces.
    const TRIANGLES: u32 = 400_000;

    /// A ribbon, and the same in two colours.
    #[expect(clippy::cast_precision_loss, reason = "an f32 holds these numbers")]
    fn scene() -> Scene {
        let count = TRIANGLES;
        let place = |i: u32| [i as f32, (i % 2) as f32, 0.0];
        let positions: Vec<_> = (0..count + 2).map(place).collect();
        let triangles: Vec<_> = (0..count).map(|i| [i, i + 1, i + 2]).collect();
        let one = MeshData {
            crease: Some(4.0),
            ..MeshData::of_triangles("one", positions, triangles)
        };
        let colour = None;
        let half = |triangles| ColourRun { triangles, colour };
        let two = MeshData {
            colours: vec![half(0..count / 2), half(count / 2..count)],
            ..one.clone()
        };
        let object = |data: MeshData| {
            let mesh = Arc::new(Mesh::new(data).expect("a mesh"));
            assert!(!mesh.normals().normals.is_empty());
            Object::new("", Shape::Mesh { mesh, part: 0 }, Placement::IDENTITY)
        };
        let cube = Object::new("", Shape::Cube, Placement::IDENTITY);
        let meshes = [one, two].map(object);
        meshes.into_iter().chain(vec![cube; 40_000]).collect()
    }

    /// Each step of an upload reports progress after every piece. If a single report is told to stop, the upload ends:
    /// none of them ignores the answer.
    #[test]
    fn every_step_of_an_upload_reports_and_can_be_the_last() {
        let gpu = Gpu::headless().expect("an adapter");
        let (scene, added) = (scene(), Scene::default());
        let upload = |stopped_at: u64| {
            let progress = Progress::default();
            progress.stopped_at.store(stopped_at, Relaxed);
            let making = Making::With(scene.clone(), added.clone());
            let uploaded = upload(&gpu, making, MeshStore::default(), &progress);
            (uploaded.map(drop), progress)
        };
        let (uploaded, progress) = upload(0);
        uploaded.expect("it fits");
        assert!((progress.fraction() - 1.0).abs() < f32::EPSILON);
        assert_eq!(gpu.uploaded_triangles(), u64::from(2 * TRIANGLES));
        let reports = progress.reports.into_inner();
        let (triangles, objects) = (TRIANGLES as usize, scene.objects().len());
        // Of making the scene, and of its rows.
        let made = objects.div_ceil(1 << 12) + 2 + objects.div_ceil(1 << 12);
        let rows = objects.div_ceil(1 << 14);
        // Of each mesh in its vertices, and in the pieces of its two buffers.
        let vertices = triangles.div_ceil(1 << 15);
        let least = made + rows + 2 * (vertices + 2);
        assert!(reports >= least as u64, "{reports} of {least}");
        for last in 1..=reports {
            let (stopped, _) = upload(last);
            let is_cancelled = matches!(stopped, Err(NotUploaded::Cancelled(_)));
            assert!(is_cancelled, "at {last} of {reports}");
        }
    }
}
