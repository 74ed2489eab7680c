//! A lost device is replaced, and nothing else is lost. What a device refuses is an error and no panic.

use super::{MIDDLE, click, press_key, row, selected};
use egui::{Key, Modifiers};
use sightline::render::Gpu;

#[test]
fn a_lost_device_is_replaced_and_everything_is_as_it_was() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    press_key(&mut window, Modifiers::NONE, Key::P);
    let before = window.picture().expect("a picture");
    assert!(!window.draw([]).expect("a frame"), "nothing had changed");
    window.lose_device();
    assert!(window.draw([]).expect("a frame"), "all of it anew");
    let after = window.picture().expect("a picture");
    assert!(before.pixels() == after.pixels());
    assert_eq!(selected(&window), Some("front"));
    assert_eq!(window.messages().count(), 0);
}

#[test]
fn what_a_device_refuses_is_an_error_and_no_panic() {
    let gpu = Gpu::headless().unwrap_or_else(|error| panic!("{error}"));
    let _ = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("read and written at once"),
        size: 4,
        usage: wgpu::BufferUsages::MAP_READ
            | wgpu::BufferUsages::VERTEX
            | wgpu::BufferUsages::INDEX,
        mapped_at_creation: true,
    });
    let error = gpu.wait().expect_err("a buffer that cannot be");
    assert!(error.to_string().contains(gpu.adapter_name()), "{error}");
    assert_eq!(error.to_string().lines().count(), 1);
    assert_eq!(gpu.wait(), Ok(()), "said once");
    assert!(!gpu.is_lost());
}
