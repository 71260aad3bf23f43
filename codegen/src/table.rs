//! Tables of a model as piecewise cubics, with their derivatives.
//!
//! A table lookup is one operation of a program, as an elementary function is. Searching the interval costs less than
//! evaluating the cubics of all intervals and selecting one, and the generated code contains the table's name.

mod bicubic;
mod cubic;

pub use bicubic::PiecewiseBicubic;
pub use cubic::PiecewiseCubic;

use model_spec::model;
use std::sync::Arc;

model_spec::index_type!(
    /// Index of a table among the tables of a model.
    pub struct TableId;
);

/// Highest order of a derivative that is not identically zero: the third derivative is constant in each interval.
pub const LAST_ORDER: u8 = 3;

/// A table of `N` arguments, one or two, or one of its derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TableFunction<const N: usize = 1> {
    table: u16,
    orders: [u8; N],
}

impl<const N: usize> TableFunction<N> {
    /// Returns the value of a table as a function.
    ///
    /// # Panics
    /// If the index exceeds `u16::MAX`, far above the number of tables of a model.
    pub fn value_of(table: TableId) -> Self {
        let table = u16::try_from(table.index()).expect("few tables");
        let orders = [0; N];
        Self { table, orders }
    }

    /// Index of the table whose value or derivative this function is.
    pub fn table(self) -> TableId {
        TableId::new(usize::from(self.table))
    }

    /// Orders of the derivative by each argument; 0 for the value of the table.
    pub fn orders(self) -> [u8; N] {
        self.orders
    }

    /// Partial derivative of this function by the argument 0 or 1; `None` if it is identically zero.
    pub fn derivative(mut self, argument: usize) -> Option<Self> {
        self.orders[argument] += 1;
        (self.orders[argument] <= LAST_ORDER).then_some(self)
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
    /// Whether it is of straight lines, whose slope jumps at the knots.
    pub is_linear: bool,
    /// [`model::Table::fingerprint`].
    pub fingerprint: u64,
    function: TableOf,
}

#[derive(Clone, Debug, PartialEq)]
enum TableOf {
    /// A function of one argument, with its derivatives.
    One([PiecewiseCubic; LAST_ORDER as usize + 1]),
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
            is_linear: table.interpolation == model::Interpolation::Linear,
            fingerprint: table.fingerprint(),
            function,
        }
    }

    /// Piecewise cubic of the value (`order` 0) or of a derivative, of an order up to [`LAST_ORDER`].
    ///
    /// # Panics
    /// If the order exceeds [`LAST_ORDER`], or the table has two arguments.
    pub fn cubic(&self, order: u8) -> &PiecewiseCubic {
        match &self.function {
            TableOf::One(derivatives) => &derivatives[usize::from(order)],
            TableOf::Two(_) => panic!("the table `{}` has two arguments", self.name),
        }
    }

    /// Piecewise bicubic of a table of two arguments.
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
    pub fn table(&self, id: TableId) -> &CubicTable {
        &self.0[id.index()]
    }

    /// Returns the piecewise cubic of a table or of its derivative.
    #[inline]
    pub fn of(&self, function: TableFunction) -> &PiecewiseCubic {
        self.table(function.table()).cubic(function.orders()[0])
    }

    /// Name of a table or its derivative: `C_L`, `C_L_slope`, of two arguments `C_L_derivative_1_0`.
    pub fn name<const N: usize>(&self, function: TableFunction<N>) -> String {
        let known = self.0.get(function.table().index());
        let name = known.map_or("", |table| table.name.as_str());
        let name = if name.is_empty() { "table" } else { name };
        match &function.orders()[..] {
            [0] | [0, 0] => name.to_owned(),
            [1] => format!("{name}_slope"),
            [order] => format!("{name}_derivative_{order}"),
            orders => { orders.iter() }.fold(format!("{name}_derivative"), |name, order| {
                format!("{name}_{order}")
            }),
        }
    }
}
