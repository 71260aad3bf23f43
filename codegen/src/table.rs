//! Tables of a model as piecewise cubics, with their derivatives.
//!
//! A table is one operation of a program, as an elementary function is: looking up the interval costs less than evaluating
//! the cubics of all intervals and choosing among them, and the printed code has the table's name.

mod cubic;

pub use cubic::PiecewiseCubic;

use model_spec::model;
use std::sync::Arc;

model_spec::index_type!(
    /// Index of a table among those of a model.
    pub struct TableId;
);

/// A table or one of its derivatives, as a function of one argument; in two bytes, as instructions of a tape hold it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TableFunction(u16);

impl TableFunction {
    /// Order of the last derivative that is not zero everywhere: the third is a constant in each interval.
    pub const LAST: u8 = 3;

    /// The value (`order` 0) or a derivative of a table.
    ///
    /// # Panics
    /// If the order exceeds [`TableFunction::LAST`], or the index 16383, far beyond the number of tables of a model.
    pub fn new(table: TableId, order: u8) -> TableFunction {
        assert!(order <= Self::LAST);
        let code = (table.index() << 2) | usize::from(order);
        TableFunction(u16::try_from(code).expect("few tables"))
    }

    /// The table.
    pub fn table(self) -> TableId {
        TableId::new(usize::from(self.0 >> 2))
    }

    /// Order of the derivative, 0 for the value.
    pub fn order(self) -> u8 {
        (self.0 & 3) as u8
    }

    /// The derivative; `None` if it is zero everywhere.
    pub fn derivative(self) -> Option<TableFunction> {
        (self.order() < Self::LAST).then_some(TableFunction(self.0 + 1))
    }
}

/// A table of a model, with its derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct CubicTable {
    /// Name of the table in the model; empty for a table that was read from generated code.
    pub name: String,
    /// Documentation of the table in the model.
    pub doc: String,
    /// Name of the argument.
    pub argument: String,
    /// Texts of the units of argument and value, SI units.
    pub unit_texts: [String; 2],
    /// Hash of the curve ([`model::Table::fingerprint`]); 0 for a table that was read from generated code.
    pub fingerprint: u64,
    derivatives: [PiecewiseCubic; TableFunction::LAST as usize + 1],
}

impl CubicTable {
    fn new(value: PiecewiseCubic) -> CubicTable {
        let first = value.derivative();
        let second = first.derivative();
        let third = second.derivative();
        CubicTable {
            name: String::new(),
            doc: String::new(),
            argument: String::new(),
            unit_texts: Default::default(),
            fingerprint: 0,
            derivatives: [value, first, second, third],
        }
    }

    /// The value (`order` 0) or a derivative, of an order of at most [`TableFunction::LAST`].
    ///
    /// # Panics
    /// If the order is higher.
    pub fn cubic(&self, order: u8) -> &PiecewiseCubic {
        &self.derivatives[usize::from(order)]
    }
}

impl From<&model::Table> for CubicTable {
    fn from(table: &model::Table) -> CubicTable {
        CubicTable {
            name: table.name.clone(),
            doc: table.doc.clone(),
            argument: table.argument.clone(),
            unit_texts: table.unit_texts.clone(),
            fingerprint: table.fingerprint(),
            ..CubicTable::new(PiecewiseCubic::of(table))
        }
    }
}

/// The tables of a model, shared by its expressions and programs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tables(Arc<[CubicTable]>);

impl Tables {
    /// Tables of a model, in its order.
    pub fn of_model(model: &model::Model) -> Tables {
        Tables(model.tables.iter().map(CubicTable::from).collect())
    }

    /// Tables without names.
    pub fn of_cubics(cubics: Vec<PiecewiseCubic>) -> Tables {
        Tables(cubics.into_iter().map(CubicTable::new).collect())
    }

    /// A table by its index.
    ///
    /// # Panics
    /// If there is no such table.
    pub fn table(&self, id: TableId) -> &CubicTable {
        &self.0[id.index()]
    }

    /// The cubics of a function.
    ///
    /// # Panics
    /// If there is no such table.
    #[inline]
    pub fn of(&self, function: TableFunction) -> &PiecewiseCubic {
        self.table(function.table()).cubic(function.order())
    }

    /// Name of a function in printed expressions and in names of variables: `C_L`, and `C_L_slope` for the derivative.
    pub fn name(&self, function: TableFunction) -> String {
        let known = self.0.get(function.table().index());
        let name = known.map_or("", |table| table.name.as_str());
        let name = if name.is_empty() { "table" } else { name };
        match function.order() {
            0 => name.to_owned(),
            1 => format!("{name}_slope"),
            order => format!("{name}_derivative_{order}"),
        }
    }
}
