//! Embree 4 and 3, where their libraries are installed. Layouts and constants are those of their `rtcore*.h`, which
//! agree except for the arguments of `rtcIntersect1`.
#![allow(unsafe_code, reason = "a library in C++")]

use crate::{
    allocations::{Cost, Count},
    meshes::Sample,
    rivals::{Answer, Built, Rival},
};
use libloading::{Library, Symbol};
use sightline::geometry::Ray;
use std::{
    ffi::{CString, c_char, c_void},
    num::NonZero,
    ptr::null_mut,
    thread,
    time::Instant,
};

type Handle = *mut c_void;

#[repr(C, align(16))]
#[derive(Clone, Copy)]
struct RayHit {
    origin: [f32; 3],
    near: f32,
    direction: [f32; 3],
    time: f32,
    far: f32,
    mask: u32,
    id: u32,
    flags: u32,
    normal: [f32; 3],
    uv: [f32; 2],
    triangle: u32,
    geometry: u32,
    instance: u32,
    /// Only Embree 4 has this field.
    instance_primitive: u32,
}

/// An argument of Embree 3's `rtcIntersect1`. Embree 4 has optional arguments in its place.
#[repr(C)]
struct Context {
    flags: u32,
    filter: Handle,
    instance: u32,
}

extern "C" fn monitor(memory: Handle, bytes: isize, _: bool) -> bool {
    // SAFETY: `memory` is what `build` passed, and lives as long as the device.
    unsafe { &*memory.cast::<Count>() }.add(bytes);
    true
}

/// Embree with medium build quality, with or without its robust mode.
struct Embree {
    library: &'static Library,
    version: Version,
    robust: bool,
}

#[derive(Clone, Copy, PartialEq)]
enum Version {
    Four,
    Three,
}

/// Both modes of each installed version, the newer version first.
pub fn installed() -> Vec<Rival> {
    let four = std::env::var("EMBREE4").unwrap_or_else(|_| "libembree4.so.4".into());
    let versions = [
        (
            Version::Four,
            vec![&*four, "libembree4.dylib", "embree4.dll"],
        ),
        (
            Version::Three,
            vec!["libembree3.so.3", "libembree3.dylib", "embree3.dll"],
        ),
    ];
    let each = versions.into_iter().filter_map(|(version, names)| {
        let mut names = names.into_iter();
        // SAFETY: loading Embree runs only its own set-up.
        let library = names.find_map(|name| unsafe { Library::new(name) }.ok())?;
        // Never unloaded: its threads outlive its scenes.
        let library: &_ = Box::leak(Box::new(library));
        Some([false, true].map(|robust| {
            let embree = Embree {
                library,
                version,
                robust,
            };
            Rival::new(embree.name(), move |sample| embree.build(sample))
        }))
    });
    each.flatten().collect()
}

macro_rules! call {
    ($library:expr, $name:literal, ($($type:ty),*) $(-> $result:ty)?, $($argument:expr),*) => {{
        // SAFETY: the signature is the header's.
        let function: Symbol<unsafe extern "C" fn($($type),*) $(-> $result)?> =
            unsafe { $library.get($name.as_bytes()) }.expect($name);
        // SAFETY: handles are alive, buffers outlive the scene, see `EmbreeScene`.
        unsafe { function($($argument),*) }
    }};
}

impl Embree {
    fn name(&self) -> &'static str {
        match (self.version, self.robust) {
            (Version::Four, false) => "Embree 4",
            (Version::Four, true) => "Embree 4 robust",
            (Version::Three, false) => "Embree 3",
            (Version::Three, true) => "Embree 3 robust",
        }
    }

    fn build(&self, sample: &Sample) -> Built {
        type Monitor = extern "C" fn(Handle, isize, bool) -> bool;
        const MEDIUM: i32 = 1;
        const ROBUST: i32 = 4;
        const TRIANGLES: i32 = 0;
        const INDEX: i32 = 0;
        const VERTEX: i32 = 1;
        const UINT3: i32 = 0x5003;
        const FLOAT3: i32 = 0x9003;
        let library = self.library;
        // Embree may read four bytes beyond the last vertex.
        let mut positions = sample.positions.clone();
        positions.push([0.0; 3]);
        let mut scene = EmbreeScene {
            library,
            version: self.version,
            device: null_mut(),
            scene: null_mut(),
            memory: Box::default(),
            positions,
            triangles: sample.triangles.clone(),
        };
        let threads = thread::available_parallelism().map_or(1, NonZero::get);
        let config = CString::new(format!("threads={threads}")).expect("no zero");
        let device = call!(library, "rtcNewDevice", (*const c_char) -> Handle, config.as_ptr());
        assert!(!device.is_null(), "Embree gives no device");
        scene.device = device;
        let memory = std::ptr::from_ref(&*scene.memory).cast_mut().cast();
        call!(
            library,
            "rtcSetDeviceMemoryMonitorFunction",
            (Handle, Monitor, Handle),
            device,
            monitor,
            memory
        );
        let start = Instant::now();
        scene.scene = call!(library, "rtcNewScene", (Handle) -> Handle, device);
        call!(
            library,
            "rtcSetSceneBuildQuality",
            (Handle, i32),
            scene.scene,
            MEDIUM
        );
        if self.robust {
            call!(
                library,
                "rtcSetSceneFlags",
                (Handle, i32),
                scene.scene,
                ROBUST
            );
        }
        let geometry = call!(library, "rtcNewGeometry", (Handle, i32) -> Handle, device, TRIANGLES);
        for (kind, format, data, count) in [
            (
                VERTEX,
                FLOAT3,
                scene.positions.as_ptr().cast::<c_void>(),
                sample.positions.len(),
            ),
            (
                INDEX,
                UINT3,
                scene.triangles.as_ptr().cast(),
                sample.triangles.len(),
            ),
        ] {
            call!(
                library,
                "rtcSetSharedGeometryBuffer",
                (Handle, i32, u32, i32, *const c_void, usize, usize, usize),
                geometry,
                kind,
                0,
                format,
                data,
                0,
                12,
                count
            );
        }
        call!(library, "rtcCommitGeometry", (Handle), geometry);
        call!(library, "rtcAttachGeometry", (Handle, Handle) -> u32, scene.scene, geometry);
        call!(library, "rtcReleaseGeometry", (Handle), geometry);
        call!(library, "rtcCommitScene", (Handle), scene.scene);
        let seconds = start.elapsed().as_secs_f64();
        let cost = Cost {
            seconds,
            memory: Some(scene.memory.held_and_peak()),
        };
        let closest = move |rays: &[Ray], answers: &mut [Answer]| scene.closest(rays, answers);
        (Box::new(closest), cost)
    }
}

/// A scene with the buffers that it shares.
struct EmbreeScene {
    library: &'static Library,
    version: Version,
    device: Handle,
    scene: Handle,
    memory: Box<Count>,
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl EmbreeScene {
    fn closest(&self, rays: &[Ray], answers: &mut [Answer]) {
        type By3 = unsafe extern "C" fn(Handle, *mut Context, *mut RayHit);
        type By4 = unsafe extern "C" fn(Handle, *mut RayHit, Handle);
        const NAME: &str = "rtcIntersect1";
        let mut context = Context {
            flags: 0,
            filter: null_mut(),
            instance: u32::MAX,
        };
        match self.version {
            Version::Three => {
                // SAFETY: the signature is the header's.
                let by: Symbol<By3> = unsafe { self.library.get(NAME.as_bytes()) }.expect(NAME);
                // SAFETY: the scene is committed; context and hit are as the header has them.
                ask(rays, answers, |hit| unsafe {
                    by(self.scene, &raw mut context, hit);
                });
            }
            Version::Four => {
                // SAFETY: the signature is the header's.
                let by: Symbol<By4> = unsafe { self.library.get(NAME.as_bytes()) }.expect(NAME);
                // SAFETY: the scene is committed; the hit is as the header has it.
                ask(rays, answers, |hit| unsafe {
                    by(self.scene, hit, null_mut());
                });
            }
        }
    }
}

#[inline]
fn ask(rays: &[Ray], answers: &mut [Answer], mut intersect: impl FnMut(&mut RayHit)) {
    for (ray, answer) in rays.iter().zip(answers) {
        #[expect(clippy::cast_possible_truncation, reason = "f32 holds it")]
        let mut hit = RayHit {
            origin: ray.origin.as_vec3().to_array(),
            near: ray.t_min as f32,
            direction: ray.direction.as_vec3().to_array(),
            time: 0.0,
            far: ray.t_max as f32,
            mask: u32::MAX,
            id: 0,
            flags: 0,
            normal: [0.0; 3],
            uv: [0.0; 2],
            triangle: u32::MAX,
            geometry: u32::MAX,
            instance: u32::MAX,
            instance_primitive: u32::MAX,
        };
        intersect(&mut hit);
        *answer = (hit.geometry != u32::MAX).then(|| (f64::from(hit.far), hit.triangle));
    }
}

impl Drop for EmbreeScene {
    fn drop(&mut self) {
        call!(self.library, "rtcReleaseScene", (Handle), self.scene);
        call!(self.library, "rtcReleaseDevice", (Handle), self.device);
    }
}
