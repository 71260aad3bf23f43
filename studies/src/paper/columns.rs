//! Possible orders of the lift and drag columns of Table 1.

/// Order of the four lift and drag columns in Table 1 of Hubbard & Hummel (2000): `columns[i]` is the index of the
/// printed column that contains the `i`-th of C_L0, C_La, C_D0, C_Da.
pub type Columns = [u8; 4];

/// Order of the four lift and drag columns as printed in Table 1 of Hubbard & Hummel (2000).
pub(super) const PRINTED: Columns = [0, 1, 2, 3];

/// Returns all 24 orders of the four lift and drag columns of Table 1 of Hubbard & Hummel (2000), sorted.
pub(super) fn orders() -> Vec<Columns> {
    let mut orders = Vec::with_capacity(24);
    for code in 0..256_u16 {
        let order = [0, 2, 4, 6].map(|shift| (code >> shift & 3) as u8);
        let mut sorted = order;
        sorted.sort_unstable();
        if sorted == PRINTED {
            orders.push(order);
        }
    }
    orders.sort_unstable();
    orders
}

/// Minimum number of interchanges of two columns that convert the printed order of columns to `order`. Each interchange
/// counts as one hypothesis on the table.
pub(super) fn interchanges(order: Columns) -> usize {
    let mut order = order;
    let mut count = 0;
    for i in 0..4 {
        while order[i] as usize != i {
            let j = order[i] as usize;
            order.swap(i, j);
            count += 1;
        }
    }
    count
}

/// Describes how an order of the four lift and drag columns differs from the printed one; `None` if it does not. Two
/// interchanged columns are written `C_L0 ↔ C_La`. In a longer cycle, `C_L0 from C_D0` means that the values of C_L0
/// are in the column printed as C_D0.
pub(super) fn describe(order: Columns) -> Option<String> {
    let names = ["C_L0", "C_La", "C_D0", "C_Da"];
    let mut changes = Vec::new();
    for i in 0..4 {
        let j = order[i] as usize;
        let interchanged = order[j] as usize == i;
        if j > i && interchanged {
            changes.push(format!("{} ↔ {}", names[i], names[j]));
        } else if j != i && !interchanged {
            changes.push(format!("{} from {}", names[i], names[j]));
        }
    }
    (!changes.is_empty()).then(|| changes.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_order_is_there_once() {
        assert_eq!(orders().len(), 24);
        assert_eq!(orders()[0], PRINTED);
    }

    #[test]
    fn interchanges_are_counted() {
        for (order, count) in [
            ([0, 1, 2, 3], 0),
            ([1, 0, 2, 3], 1),
            ([1, 0, 3, 2], 2),
            ([1, 2, 3, 0], 3),
        ] {
            assert_eq!(interchanges(order), count, "{order:?}");
        }
    }
}
