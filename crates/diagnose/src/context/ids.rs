//! Index types of a diagnosis.

use model_spec::index_type;

index_type!(
    /// Index of a candidate effect.
    pub(crate) struct CandidateId;
);

index_type!(
    /// Index of a library term on its load channel.
    pub(crate) struct TermId;
);

index_type!(
    /// Index of a global column of the normal equations: the global parameters of the encompassing model, then one
    /// coefficient for each library term.
    pub(crate) struct ColumnId;
);

index_type!(
    /// Index of a local column of one flight's normal equations: a direction of its initial-state manifold.
    pub(crate) struct DirectionId;
);
