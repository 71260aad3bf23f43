//! Nothing: the manifest lists features.

use {
    bytemuck as _, either as _, getrandom as _, libc as _, matrixmultiply as _, num_complex as _,
    num_integer as _, once_cell as _, rand as _, regex_automata as _, regex_syntax as _,
    rustix as _, serde as _, serde_json as _, similar as _, syn as _, zerocopy as _,
};
