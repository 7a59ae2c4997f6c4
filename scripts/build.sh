# Configuring and building with few words. Sourced by the scripts, which set -o pipefail.

# configure PRESET [OPTION...]: CMake's words only where it fails.
configure() {
  local said
  said=$(cmake --preset "$@" 2>&1) || { echo "$said"; return 1; }
}

# build PRESET TARGET...: one line that says how far it is and what is being made; on a terminal it overwrites itself,
# elsewhere it comes every ten seconds. Everything else (warnings, errors) is shown as it is.
build() {
  local preset=$1 terminal=0
  shift
  if [ -t 1 ]; then terminal=1; fi
  NINJA_STATUS='[%f/%t %e s] ' cmake --build --preset "$preset" --target "$@" | awk -v terminal="$terminal" '
    function clear() { if (terminal && shown) printf "\r\033[K"; shown = 0 }
    /^\[[0-9]+\/[0-9]+ [0-9.]+ s\] / {
      done = substr($1, 2); seconds = $2
      what = $NF
      sub(/CMakeFiles\/[^\/]*\.dir\//, "", what); sub(/\.o$/, "", what)
      line = sprintf("%s  %d:%02d  %s", done, seconds / 60, seconds % 60, what)
      if (terminal) { printf "\r\033[K%s", line; shown = 1 }
      else if (seconds >= next_at) { print line; next_at = seconds + 10 }
      fflush(); next
    }
    { clear(); print; fflush() }
    END { clear() }'
}
