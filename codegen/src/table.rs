//! Tables of a model as piecewise cubics, with their derivatives.
//!
//! A table lookup is one operation of a program, as an elementary function is. Searching the interval costs less than
//! evaluating the cubics of all intervals and selecting one, and the generated code contains the table's name.

mod bicubic;
mod cubic;

pub use bicubic::{PiecewiseBicubic, SurfaceFunction};
pub use cubic::PiecewiseCubic;

use model_spec::model;
use std::sync::Arc;

model_spec::index_type!(
    /// Index of a table among the tables of a model.
    pub struct TableId;
);

/// A table or one of its derivatives, as a function of one argument; encoded in two bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TableFunction(u16);

impl TableFunction {
    /// Highest order of a derivative that is not identically zero: the third derivative is constant in each interval.
    pub const LAST: u8 = 3;

    /// Returns the function of a table (`order` 0) or of its derivative of the given order.
    ///
    /// # Panics
    /// If the order exceeds [`TableFunction::LAST`], or the index exceeds 16383, far above the number of tables of a
    /// model.
    pub fn new(table: TableId, order: u8) -> TableFunction {
        assert!(order <= Self::LAST);
        let code = (table.index() << 2) | usize::from(order);
        TableFunction(u16::try_from(code).expect("few tables"))
    }

    /// Index of the table whose value or derivative this function is.
    pub fn table(self) -> TableId {
        TableId::new(usize::from(self.0 >> 2))
    }

    /// Order of the derivative; 0 for the value of the table.
    pub fn order(self) -> u8 {
        (self.0 & 3) as u8
    }

    /// Derivative of this function; `None` if it is identically zero.
    pub fn derivative(self) -> Option<TableFunction> {
        (self.order() < Self::LAST).then_some(TableFunction(self.0 + 1))
    }
}

/// Table of a model as a piecewise cubic with its derivatives, or as a piecewise bicubic.
#[derive(Clone, Debug, PartialEq)]
pub struct CubicTable {
    /// Name of the table in the model.
    pub name: String,
    /// Doc comment (`///` lines) of the table in the model.
    pub doc: String,
    /// Name and SI unit, as text, of each of the table's arguments.
    pub arguments: Vec<(String, String)>,
    /// [`model::Table::fingerprint`].
    pub fingerprint: u64,
    function: TableOf,
}

#[derive(Clone, Debug, PartialEq)]
enum TableOf {
    /// A function of one argument, with its derivatives.
    One([PiecewiseCubic; TableFunction::LAST as usize + 1]),
    Two(PiecewiseBicubic),
}

impl CubicTable {
    fn of(table: &model::Table) -> CubicTable {
        let function = if table.arguments.len() == 1 {
            let value = PiecewiseCubic::of(table);
            let first = value.derivative();
            let second = first.derivative();
            let third = second.derivative();
            TableOf::One([value, first, second, third])
        } else {
            TableOf::Two(PiecewiseBicubic::of(table))
        };
        let arguments = table.arguments.iter();
        CubicTable {
            name: table.name.clone(),
            doc: table.doc.clone(),
            arguments: arguments
                .map(|own| (own.name.clone(), own.unit_text.clone()))
                .collect(),
            fingerprint: table.fingerprint(),
            function,
        }
    }

    /// Piecewise cubic of the value (`order` 0) or of a derivative, of an order up to [`TableFunction::LAST`].
    ///
    /// # Panics
    /// If the order exceeds [`TableFunction::LAST`], or the table has two arguments.
    pub fn cubic(&self, order: u8) -> &PiecewiseCubic {
        match &self.function {
            TableOf::One(derivatives) => &derivatives[usize::from(order)],
            TableOf::Two(_) => panic!("the table `{}` has two arguments", self.name),
        }
    }

    /// Piecewise bicubic of a table of two arguments.
    ///
    /// # Panics
    /// If the table has one argument.
    pub fn bicubic(&self) -> &PiecewiseBicubic {
        match &self.function {
            TableOf::One(_) => panic!("the table `{}` has one argument", self.name),
            TableOf::Two(bicubic) => bicubic,
        }
    }
}

/// The tables of a model, shared by its expressions and programs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tables(Arc<[CubicTable]>);

impl Tables {
    /// Tables of a model, in their order in the model.
    pub fn of_model(model: &model::Model) -> Tables {
        Tables(model.tables.iter().map(CubicTable::of).collect())
    }

    /// Returns the table with the index `id`.
    ///
    /// # Panics
    /// If no table has this index.
    pub fn table(&self, id: TableId) -> &CubicTable {
        &self.0[id.index()]
    }

    /// Returns the piecewise cubic of a table or of its derivative.
    ///
    /// # Panics
    /// If the function belongs to a table that is not in `self`.
    #[inline]
    pub fn of(&self, function: TableFunction) -> &PiecewiseCubic {
        self.table(function.table()).cubic(function.order())
    }

    /// Name of a table or its derivative: `C_L`, `C_L_slope`.
    pub fn name(&self, function: TableFunction) -> String {
        let name = self.base_name(function.table());
        match function.order() {
            0 => name.to_owned(),
            1 => format!("{name}_slope"),
            order => format!("{name}_derivative_{order}"),
        }
    }

    /// Name of a table of two arguments or of its derivative: `C_L`, `C_L_derivative_1_0`.
    pub fn surface_name(&self, function: SurfaceFunction) -> String {
        let name = self.base_name(function.table());
        match function.orders() {
            [0, 0] => name.to_owned(),
            [by_first, by_second] => format!("{name}_derivative_{by_first}_{by_second}"),
        }
    }

    fn base_name(&self, table: TableId) -> &str {
        let known = self.0.get(table.index());
        let name = known.map_or("", |table| table.name.as_str());
        if name.is_empty() { "table" } else { name }
    }
}
