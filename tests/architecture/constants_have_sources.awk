# Reads C++ files and prints a line for each named constant (kName) that holds a number:
#   <layer> <file>:<line> <name> <sourced or bare> <unit or unitless>
# Run by constants_have_sources.sh in the source tree. Texts, tables made by a function and `if
# constexpr` are no constants that decide something.
#
# A source is: another constant that the value is computed from; a comment on the line or directly
# above that has six words or more, room enough for a reason; or a shorter one that names where the
# number comes from. A comment above speaks for up to four neighbours that no empty line divides.
# A unit is: a suffix of the name (distance_m), a whole number or a type of time, or a name or comment
# that says what is counted (a share, a price, log-odds).

function words(text, parts) {
  gsub(/[^A-Za-z]+/, " ", text)
  return split(text, parts, " ")
}

function says_source(text) {
  return words(text) >= 6 ||
         tolower(text) ~ /by hand|ours|paper|section|derived|measured|tuned|chosen|standard|protocol|manual|chi squared|as in |settings::/
}

function says_unit(text) {
  return name ~ /_[a-z0-9]+$/ || type !~ /double|float/ ||
         tolower(name " " text) ~ /share|log-odds|ratio|factor|weight|score|gain|probability|confidence|per |times|price|worth|costs?|sigma|std|grey|pixel|px|cell|column|look|picture|metre|degree|contrast|strength|logarithm|chi squared|still \.\.|root of|sigmas|cost|steps|half|laplace|the bound/
}

# A constant is read to its semicolon: counts it.
function finish(value, text) {
  open = 0
  value = initialiser
  text = above " " trailing
  if (value !~ /[0-9]/) return
  gsub(/[A-Za-z_]+[A-Za-z0-9_]*/, "", value)
  if (value !~ /[0-9]/) return  # from other names alone
  derived = initialiser ~ /(^|[^A-Za-z0-9_])k[A-Z][A-Za-z0-9]/
  print layer, FILENAME ":" first, name, derived || says_source(text) ? "sourced" : "bare",
        derived || says_unit(text) ? "unit" : "unitless"
  if (++covered >= 4) above = ""
}

FNR == 1 {
  above = ""
  covered = open = 0
  layer = FILENAME
  sub(/\/.*/, "", layer)
}

{
  comment = ""
  code = $0
  if (match($0, /\/\/+<?/)) {
    code = substr($0, 1, RSTART - 1)
    comment = substr($0, RSTART + RLENGTH)
  }
}

open {  # the initialiser goes on
  initialiser = initialiser code
  trailing = trailing " " comment
  if (code ~ /;/) finish()
  next
}

# What stands behind a declaration may go on below it, far to the right.
code ~ /^                    +$/ && comment != "" && covered == 0 && above == "" { next }

code ~ /^[ \t]*$/ && comment != "" {
  above = covered ? comment : above " " comment
  covered = 0
  next
}

code ~ /(constexpr|const)[ >].*[ ]k[A-Z][A-Za-z0-9_]*(\[[^\]]*\])?[ ]*(=|\{)/ &&
code !~ /if constexpr|char\*|char \*|string|auto k[A-Z][A-Za-z]* = (make|\[)/ {
  match(code, /[ ]k[A-Z][A-Za-z0-9_]*(\[[^\]]*\])?[ ]*(=|\{)/)
  type = substr(code, 1, RSTART)
  initialiser = substr(code, RSTART + RLENGTH)
  name = substr(code, RSTART + 1, RLENGTH - 1)
  sub(/[^A-Za-z0-9_].*/, "", name)
  trailing = comment
  first = FNR
  open = 1
  if (code ~ /;/) finish()
  next
}

{
  above = ""
  covered = 0
}
