"""What the counter must say of one line of each kind: `python3 benches/peers/test_count_ops.py`."""

from count_ops import count, functions

TABLE = [
    ("let a = b * c + d.sqrt();", {"*": 1, "+": 1, "sqrt": 1}),
    ("let (s, c) = theta.sin_cos();", {"sin": 1, "cos": 1}),
    ("let a: f64 = (b).atan2(-c);", {"atan2": 1, "neg": 1}),
    ("const double t = -1.0/2.0*x + 3.0*y;", {"*": 2, "+": 1}),
    ("a0=(a1-(2.*a2));", {"-": 1, "*": 1}),
    ("a0=casadi_sq(a1); a2=arg[0]? arg[0][3] : 0;", {"*": 1}),
    ("if (res[0]!=0) res[0][1+2]=a0;", {}),
    ("let v = (2i64) as f64 * ((1i64) as f64 / (a * a));", {"*": 2, "/": 1}),
    ("y = pow(x, 2);", {"*": 1}),
    ("y = pow(x, -3.0/2.0);", {"*": 1, "sqrt": 1, "/": 1}),
    ("y = pow(x, 5) + std::pow(x, 0.3);", {"*": 3, "+": 1, "pow": 1}),
    ("let y = x.powi(3);", {"*": 2}),
    ("out[i + 1] = -(a - b);", {"-": 1, "neg": 1}),
    ("[a * b, -c, 1.0 - d]", {"*": 1, "-": 1, "neg": 1}),
    ("State { x: a * b, y: -0.5 * c }", {"*": 2}),
    ("*out = a.mul_add(b, c);", {"*": 1, "+": 1}),
    ("*out = a.mul_sub(b, c) - a.neg_mul_add(b, -c);", {"*": 2, "-": 3, "neg": 1}),
    ("out_f.set(0, 0, a / b);", {"/": 1}),
    ("v += a;", {"+": 1}),
]

for text, wanted in TABLE:
    got = count("{" + text + "}")
    counts = {k: n for k, n in got.items() if not k.startswith("total")}
    assert counts == wanted, f"{text}\n  counted {counts}\n  expected {wanted}"

assert count("{ y = strange(a * b); }")["calls"] == {"strange": 1}
found = functions("pub fn one(x: &[f64; 12]) -> [f64; 2] {\n [x[0] * x[1], 0.0]\n}\nvoid two(double* o) { o[0] = 1.0 + o[1]; }")
assert {n: count(t)["total"] for n, t in found.items()} == {"one": 1, "two": 1}
print(f"{len(TABLE) + 2} lines counted right")
