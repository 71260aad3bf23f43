//! Typed indices (newtypes) used in a diagnosis.

use model_spec::index_type;

index_type!(
    /// Index of a candidate effect: an effect that the model may lack.
    pub(crate) struct CandidateId;
);

index_type!(
    /// Index of a library term: a product of variables that is added to one load.
    pub(crate) struct TermId;
);

index_type!(
    /// Index of a global column of the normal equations. The columns are those of the encompassing model's global
    /// parameters, then one column for the coefficient of each library term.
    pub(crate) struct ColumnId;
);
