(block) @fold
(table) @fold
