//! Names as the model spells them, in options and releases.

use crate::cli::{hyzer, stderr, stdout};

/// Names may be spelt as in the model, in options and in releases; what is computed cannot be set.
#[test]
fn names_are_read_as_the_model_spells_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    let model = "model rod;\nframe N;\nparam m = 1 kg;\nparam twice = 2*m;\nparam ρ = 2;\n\
        coefficient k[i] for i in 1..2 = 0 N;\n\
        point p { mass m; position (x, y, z) in N = (0, 0, -2) m; velocity (vx, vy, vz) in N; }\n\
        solve rod {\n  unknown T: N;\n  constraint norm(position) = 2 m within 1 mm;\n}\n\
        force rod = -T*unit(position);\nforce push = (k[1] + ρ*k[2])*N.1;\nlet pull = ρ*T;\n";
    std::fs::write(path("rod.hyz"), model).expect("a file");
    let rod = path("rod.hyz");
    let rod = rod.to_str().expect("text");
    let simulate = ["simulate", rod, "--until", "0.1", "--set"];
    let told = stdout(hyzer().args(simulate).args(["k[1]=0.5", "--set", "ρ=3"]), 0);
    assert!(
        told.contains("ended by time") && told.contains("; ends at x"),
        "{told}"
    );
    let refused = stderr(hyzer().args(simulate).arg("twice=3"), 2);
    assert!(
        refused.contains("twice is computed from other parameters"),
        "{refused}"
    );
    let start = "[initial]\nx = 0\ny = 0\nz = -2\nvx = 0\nvy = 0\nvz = 0\n";
    let release = |constants: &str| {
        let text = format!("model = {rod:?}\nduration = 0.1\n{constants}{start}");
        std::fs::write(path("release.toml"), text).expect("a file");
        path("release.toml")
    };
    let own = release("[parameters]\n\"ρ\" = 3\n[coefficients]\n\"k[2]\" = 0.1\n");
    stdout(hyzer().arg("simulate").arg("--release").arg(own), 0);
    let own = release("[parameters]\ntwice = 3\n[coefficients]\n\"k[2]\" = 1\nk_2 = 2\n");
    let refused = stderr(hyzer().arg("simulate").arg("--release").arg(own), 2);
    assert!(
        refused.contains("twice is computed from other parameters"),
        "{refused}"
    );
    assert!(refused.contains("is there twice"), "{refused}");
    // An unknown is explained by what determines it, not by itself.
    let explain = ["explain", rod, "T", "--format", "text"];
    let told = stdout(hyzer().args(explain), 0);
    assert!(told.contains("T = ") && !told.contains("T = T\n"), "{told}");
    let told = stdout(hyzer().args(["explain", rod, "pull", "--wrt", "ρ"]), 0);
    assert!(told.contains("pull by rho"), "{told}");
    stdout(
        hyzer().args(["explain", rod, "force push", "--wrt", "k[2]"]),
        0,
    );
}
