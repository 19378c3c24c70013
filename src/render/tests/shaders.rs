//! Every shader is sound by wgpu's own checker, before any driver sees it.

use wgpu::naga::front::wgsl;
use wgpu::naga::valid::{Capabilities, ValidationFlags, Validator};

use crate::render::shaders::{Kind, shader_text};
use crate::render::{blit_pass, occlusion_pass};

#[test]
fn all_shaders_pass_validation_with_no_optional_capability() {
    let texts = [
        ("surface", shader_text(Kind::Surface)),
        ("lines", shader_text(Kind::Lines)),
        ("points", shader_text(Kind::Points)),
        ("occlusion", occlusion_pass::shader_text()),
        ("blit", blit_pass::SHADER.to_owned()),
    ];
    for (name, text) in texts {
        let module = wgsl::parse_str(&text)
            .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(&text)));
        Validator::new(ValidationFlags::all(), Capabilities::empty())
            .validate(&module)
            .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(&text)));
    }
}
