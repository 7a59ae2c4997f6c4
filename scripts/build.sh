# Configuring and building with few words. Sourced by the scripts, which set -o pipefail.

# configure PRESET [OPTION...]: CMake's words only where it fails.
configure() {
  local said
  said=$(cmake --preset "$@" 2>&1) || { echo "$said"; return 1; }
}

# build PRESET TARGET...: one line that says how far it is and what is being made; on a terminal it overwrites itself,
# elsewhere it comes every ten seconds. Everything else (warnings, errors) is shown as it is. At the end: how long it
# took, and the processors' time, which tells more about the build than about what else the machine was doing.
build() {
  local preset=$1 status=0 TIMEFORMAT='%R %U %S' took
  shift
  exec 3>&1 4>&2
  took=$({ time NINJA_STATUS='[%f/%t %e s] ' cmake --build --preset "$preset" --target "$@" 2>&4 | show_progress >&3; } 2>&1) ||
    status=$?
  exec 3>&- 4>&-
  awk '{ printf "Built in %d:%02d (%.1f minutes of processor time)\n", $1 / 60, $1 % 60, ($2 + $3) / 60 }' <<<"$took"
  return $status
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
