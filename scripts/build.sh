# Configuring and building with few words. Sourced by the scripts, which set -o pipefail.

# configure PRESET [OPTION...]: CMake's words only where it fails.
configure() {
  local said
  said=$(cmake --preset "$@" 2>&1) || { echo "$said"; return 1; }
}

# build PRESET TARGET...: one line that says how far it is and what is being made; on a terminal it overwrites itself,
# elsewhere it comes every ten seconds. Everything else (warnings, errors) is shown as it is.
build() {
  local preset=$1
  shift
  NINJA_STATUS='[%f/%t %e s] ' cmake --build --preset "$preset" --target "$@" | show_progress
}

show_progress() {
  local line done seconds what next=0 before='' after=$'\n'
  if [ -t 1 ]; then before=$'\r\e[K' after=''; fi
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+/[0-9]+)\ ([0-9]+)[.0-9]*\ s\]\ .*[[:space:]]([^[:space:]]+)$ ]]; then
      done=${BASH_REMATCH[1]} seconds=$((10#${BASH_REMATCH[2]})) what=${BASH_REMATCH[3]%.o}
      if [[ $what =~ ^(.*)CMakeFiles/[^/]*\.dir/(.*)$ ]]; then what=${BASH_REMATCH[1]}${BASH_REMATCH[2]}; fi
      if [ -n "$before" ] || [ "$seconds" -ge "$next" ]; then
        printf '%s%s  %d:%02d  %s%s' "$before" "$done" $((seconds / 60)) $((seconds % 60)) "$what" "$after"
        next=$((seconds + 10))
      fi
    else
      printf '%s%s\n' "$before" "$line"
    fi
  done
  printf '%s' "$before"
}
