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

/// Mesa's drivers for the processor compile a shader anew for every draw if it branches on uniforms alone, and keep what
/// they compiled.
#[test]
fn no_shader_branches_on_uniforms_alone() {
    let texts = [
        shader_text(Kind::Surface),
        shader_text(Kind::Lines),
        shader_text(Kind::Points),
        occlusion_pass::shader_text(),
        blit_pass::SHADER.to_owned(),
    ];
    let uniforms = ["view.", "surface.", "lines.", "points.", "blit."];
    let varying = ["distance", "in.", "value", "number"];
    let mut branches = 0;
    for line in texts.iter().flat_map(|text| text.lines()) {
        let code = line.split("//").next().unwrap_or_default().trim_start();
        let branch = ["if ", "} else if ", "for ", "while "];
        if !branch.iter().any(|word| code.starts_with(word)) {
            continue;
        }
        branches += 1;
        let asks = |names: &[&str]| names.iter().any(|name| code.contains(name));
        assert!(!asks(&uniforms) || asks(&varying), "{line}");
    }
    assert!(branches > 10);
}
