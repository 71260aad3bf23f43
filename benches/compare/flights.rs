//! Whole flights: FrisPy's own, against FrisPy, and the backhand of our disc.

use generated::disc;
use libloading::Library;
use ode::{Event, IntegrationOptions, Method, integrate, integrate_to_end, rhs_from_fn};
use serde_json::Value;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// A flight, timed.
pub struct Timed {
    /// What was flown and how.
    pub title: String,
    /// Median, µs.
    pub microseconds: f64,
    /// Greatest difference from the reference at the landing, of each state's magnitude or 1.
    pub error: Option<f64>,
    /// Steps and evaluations.
    pub work: String,
}

type Prepare = unsafe extern "C" fn(*const f64, *mut f64);
type Rate = unsafe extern "C" fn(*const f64, *const f64, *const f64, *mut f64);

/// FrisPy's times in ms for the same flight to the landing: at its default tolerances, and at 1e-6.
pub fn frispy(root: &Path) -> Option<Value> {
    let python = root.join("target/peers/venv/bin/python");
    let script = root.join("benches/peers/frispy_flight.py");
    let output = Command::new(python).arg(script).output().ok()?;
    serde_json::from_slice(&output.stdout).ok()
}

/// FrisPy's flight by our tape and by generated code, and ours of a backhand.
pub fn measure(root: &Path, landing: &Value) -> Result<Vec<Timed>, String> {
    let path = root.join("model-spec/refuted/frispy.hyz");
    let model = model_spec::load::load(&path.to_string_lossy(), &[]).map_err(|e| e.to_string())?;
    let compiled = codegen::compile(&model);
    let layout = &compiled.layout;
    let (x, p) = (layout.default_states(), layout.default_parameters());
    let start: [f64; 12] = x.try_into().map_err(|_| "twelve states".to_string())?;
    let reference: Vec<f64> = std::iter::once("t".to_string())
        .chain(model.states.iter().map(|state| state.name.clone()))
        .map(|name| landing[&name].as_f64().ok_or(name))
        .collect::<Result<_, _>>()?;

    let tape = codegen::TapeModel::new(&compiled);
    let k = tape.prepare(&p);
    let mut scratch = codegen::tape_model::Scratch::default();
    let by_tape = |t: f64, x: &[f64; 12], dx: &mut [f64; 12]| {
        let at = codegen::tape_model::At {
            t,
            x,
            p: &p,
            prepared: &k,
        };
        tape.f.eval(at, &[], &mut scratch, &mut [dx]);
    };
    let mut timed = vec![fly_frispy(
        ("tape", Method::Tsit5),
        &start,
        &reference,
        by_tape,
    )];

    let library = compile(root, &model)?;
    // SAFETY: the library is our own, with these two symbols of these types (see EXPORTS).
    let (prepare, rate) = unsafe {
        let prepare = library
            .get::<Prepare>(b"prepare")
            .map_err(|e| e.to_string())?;
        let rate = library.get::<Rate>(b"rate").map_err(|e| e.to_string())?;
        (*prepare, *rate)
    };
    let mut k = vec![0.0; compiled.prepared.len()];
    // SAFETY: lengths are those of the same model.
    unsafe { prepare(p.as_ptr(), k.as_mut_ptr()) };
    let by_code = |_: f64, x: &[f64; 12], dx: &mut [f64; 12]| {
        // SAFETY: as above.
        unsafe { rate(x.as_ptr(), p.as_ptr(), k.as_ptr(), dx.as_mut_ptr()) }
    };
    for method in [Method::Tsit5, Method::Dop853] {
        let how = ("generated code", method);
        timed.push(fly_frispy(how, &start, &reference, by_code));
    }
    timed.push(backhand());
    Ok(timed)
}

fn fly_frispy(
    (how, method): (&str, Method),
    start: &[f64; 12],
    reference: &[f64],
    mut rate: impl FnMut(f64, &[f64; 12], &mut [f64; 12]),
) -> Timed {
    let options = IntegrationOptions {
        method,
        rtol: 1e-6,
        atol: 1e-9,
        ..IntegrationOptions::default()
    };
    let mut frispy = rhs_from_fn(&[], |t, x: &[f64; 12], dx: &mut [f64; 12]| rate(t, x, dx));
    let mut once = || {
        let ground = Event::falls_to("ground", 2, 0.0).terminal();
        integrate_to_end(
            &mut frispy,
            (0.0, black_box(start)),
            10.0,
            &options,
            &mut [ground],
        )
        .expect("a flight to the ground")
    };
    let end = once();
    let found = std::iter::once(end.time).chain(end.state);
    let error = found
        .zip(reference)
        .map(|(found, want)| (found - want).abs() / want.abs().max(1.0));
    Timed {
        title: format!("FrisPy's flight by hyzer, {how}, {method:?}, rtol 1e-6, atol 1e-9"),
        microseconds: median_microseconds(|| _ = black_box(once())),
        error: Some(error.fold(0.0, f64::max)),
        work: format!(
            "{} steps, {} evaluations",
            end.stats.steps, end.stats.evaluations
        ),
    }
}

/// The backhand of the built-in release, to the ground, the curve kept.
fn backhand() -> Timed {
    let text = flight::release::built_in("backhand").expect("the release");
    let model = model_spec::load::load("disc", &[]).expect("the model");
    let vocabulary = flight::release::Vocabulary::of(&model);
    let release = flight::release::read("backhand", text, |_| Ok(vocabulary)).expect("a release");
    let defaults = disc::PARAMETERS.into_iter().zip(disc::DEFAULTS);
    let p = release.constants(defaults);
    let x: [f64; 12] = release.state().try_into().expect("twelve states");
    let mut k = [0.0; disc::PREPARED.len()];
    let p: [f64; disc::PARAMETERS.len()] = p.try_into().expect("all parameters");
    (disc::MODEL.prepare)(&p, &mut k);
    let mut disc = rhs_from_fn(&disc::STATES, |t, x: &[f64; 12], dx: &mut [f64; 12]| {
        (disc::MODEL.f)(t, x, &p, &k, dx);
    });
    let options = IntegrationOptions::with_tolerance(1e-6);
    let mut once = || {
        let ground = Event::falls_to("ground", 2, 0.0).terminal();
        integrate(
            &mut disc,
            (0.0, black_box(&x)),
            600.0,
            &options,
            &mut [ground],
        )
        .expect("a flight to the ground")
    };
    let end = once();
    Timed {
        title: format!(
            "our disc's backhand, {:.2} s to the ground, at 1e-6",
            end.end
        ),
        microseconds: median_microseconds(|| _ = black_box(once())),
        error: None,
        work: format!(
            "{} steps, {} evaluations",
            end.stats.steps, end.stats.evaluations
        ),
    }
}

fn median_microseconds(mut f: impl FnMut()) -> f64 {
    let mut rounds: Vec<f64> = (0..201)
        .map(|_| {
            let start = Instant::now();
            (0..20).for_each(|_| f());
            start.elapsed().as_secs_f64() * 1e6 / 20.0
        })
        .collect();
    rounds.sort_by(f64::total_cmp);
    rounds[rounds.len() / 2]
}

const MANIFEST: &str = r#"[package]
name = "frispy_by_hyzer"
version = "0.0.0"
edition = "2024"
[lib]
crate-type = ["cdylib"]
[dependencies]
lanes = { package = "hyzer-lanes", path = "LANES" }
[workspace]
"#;

const EXPORTS: &str = r#"
/// See `frispy::prepare`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn prepare(p: *const f64, k: *mut f64) {
    unsafe { frispy::prepare::<f64>(&*p.cast(), &mut *k.cast()) }
}

/// See `frispy::f`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rate(x: *const f64, p: *const f64, k: *const f64, dx: *mut f64) {
    unsafe { (frispy::MODEL.f)(0.0, &*x.cast::<[f64; 12]>(), &*p.cast::<[f64; frispy::PARAMETERS.len()]>(), &*k.cast::<[f64; frispy::PREPARED.len()]>(), &mut *dx.cast::<[f64; 12]>()) }
}
"#;

/// The model's generated code as a library of its own, in target/peers/frispy.
fn compile(root: &Path, model: &model_spec::model::Model) -> Result<Library, String> {
    let folder: PathBuf = root.join("target/peers/frispy");
    let lanes = root.join("crates/lanes");
    let mut files = codegen::generate::generate(std::slice::from_ref(model));
    for file in &mut files {
        if file.path == "lib.rs" {
            file.text.push_str(EXPORTS);
        }
        file.path = format!("src/{}", file.path);
    }
    let manifest = MANIFEST.replace("LANES", &lanes.to_string_lossy());
    files.push(codegen::backend::SourceFile {
        path: "Cargo.toml".to_string(),
        text: manifest,
    });
    for codegen::backend::SourceFile { path, text } in files {
        let path = folder.join(path);
        std::fs::create_dir_all(path.parent().unwrap_or(&folder)).map_err(|e| e.to_string())?;
        std::fs::write(path, text).map_err(|e| e.to_string())?;
    }
    let done = Command::new(env!("CARGO"))
        .args([
            "build",
            "--release",
            "--quiet",
            "--offline",
            "--target-dir",
            "target",
        ])
        .current_dir(&folder)
        .env_remove("CARGO_TARGET_DIR")
        .output()
        .map_err(|e| e.to_string())?;
    if !done.status.success() {
        return Err(String::from_utf8_lossy(&done.stderr).into_owned());
    }
    let name = libloading::library_filename("frispy_by_hyzer");
    // SAFETY: our own library, without initialisers.
    unsafe { Library::new(folder.join("target/release").join(name)) }.map_err(|e| e.to_string())
}
