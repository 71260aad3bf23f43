(keyword) @keyword
(comment) @comment
(documentation) @comment.documentation
(string) @string
(number) @number
(unit) @type
(frame) @module
(call function: (name) @function)
(declaration name: (name) @variable.definition)
["+" "-" "−" "*" "/" "·" "⋅" "×" "^" "=" ">" ".." (superscript)] @operator
["(" ")" "[" "]" "{" "}"] @punctuation.bracket
["," ";" ":" "."] @punctuation.delimiter
((name) @variable.builtin
  (#any-of? @variable.builtin
    "pi" "time" "previous" "position" "velocity" "angular_velocity" "specific_force" "angular_acceleration"))
