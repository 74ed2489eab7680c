//! Embree 3, where its library is installed (Debian, Ubuntu: `libembree3-3`). Layouts and constants are those of its
//! `embree3/rtcore*.h`.
#![allow(unsafe_code, reason = "a library in C++")]

use crate::{
    memory::{Cost, Count},
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
}

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

/// Medium quality, or medium with its robust mode.
pub struct Embree {
    library: &'static Library,
    robust: bool,
}

/// Both kinds; none where the library is not.
pub fn installed() -> Vec<Embree> {
    // SAFETY: loading Embree runs only its own set-up.
    let library = ["libembree3.so.3", "libembree3.dylib", "embree3.dll"]
        .iter()
        .find_map(|name| unsafe { Library::new(name) }.ok());
    // Never unloaded: its threads outlive its scenes.
    let library = library.map(|library| &*Box::leak(Box::new(library)));
    let kinds = [false, true].map(|robust| {
        Some(Embree {
            library: library?,
            robust,
        })
    });
    kinds.into_iter().flatten().collect()
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

impl Rival for Embree {
    fn name(&self) -> &'static str {
        if self.robust {
            "Embree robust"
        } else {
            "Embree"
        }
    }

    fn build(&self, sample: &Sample) -> (Box<dyn Built>, Cost) {
        type Monitor = extern "C" fn(Handle, isize, bool) -> bool;
        const MEDIUM: i32 = 1;
        const ROBUST: i32 = 4;
        const TRIANGLES: i32 = 0;
        const INDEX: i32 = 0;
        const VERTEX: i32 = 1;
        const UINT3: i32 = 0x5003;
        const FLOAT3: i32 = 0x9003;
        let library = self.library;
        // It may read four bytes beyond the last vertex.
        let mut positions = sample.positions.clone();
        positions.push([0.0; 3]);
        let mut scene = EmbreeScene {
            library,
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
        let [held, peak] = scene.memory.held_and_peak();
        let cost = Cost {
            seconds,
            held,
            peak,
        };
        (Box::new(scene), cost)
    }
}

/// A scene with what it was made from.
struct EmbreeScene {
    library: &'static Library,
    device: Handle,
    scene: Handle,
    memory: Box<Count>,
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Built for EmbreeScene {
    fn closest(&self, rays: &[Ray], answers: &mut [Answer]) {
        type Intersect = unsafe extern "C" fn(Handle, *mut Context, *mut RayHit);
        // SAFETY: the signature is the header's.
        let intersect: Symbol<Intersect> =
            unsafe { self.library.get(b"rtcIntersect1") }.expect("rtcIntersect1");
        let mut context = Context {
            flags: 0,
            filter: null_mut(),
            instance: u32::MAX,
        };
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
            };
            // SAFETY: the scene is committed; context and hit are as the header has them.
            unsafe { intersect(self.scene, &raw mut context, &raw mut hit) };
            *answer = (hit.geometry != u32::MAX).then(|| (f64::from(hit.far), hit.triangle));
        }
    }
}

impl Drop for EmbreeScene {
    fn drop(&mut self) {
        call!(self.library, "rtcReleaseScene", (Handle), self.scene);
        call!(self.library, "rtcReleaseDevice", (Handle), self.device);
    }
}
