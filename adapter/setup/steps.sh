# SPDX-License-Identifier: AGPL-3.0-or-later
# shellcheck shell=bash
#
# The set-up steps that ./run and ./test share. Each says what it does and how long it usually
# takes, does nothing when its inputs have not changed, and can be interrupted and run again.
# Sourced; expects `set -euo pipefail`.

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
setup=$project/adapter/setup
# Outside the build tree, so that a fresh clone on the same machine finds POV-Ray built already.
cache=${XDG_CACHE_HOME:-$HOME/.cache}/povpreview
logs=$cache/logs

# Compiled objects are reused across clones and after an interruption.
export CCACHE_DIR=$cache/ccache CCACHE_MAXSIZE=2G CCACHE_BASEDIR=$project CCACHE_NOHASHDIR=1

say() { printf 'povpreview set-up: %s\n' "$*" >&2; }
fail() {
    say "$*"
    exit 2
}

# logged NAME COMMAND...: runs a command with its output in a log file, and a sign of life on the
# terminal; shows the end of the log when it fails.
logged() {
    local name=$1
    shift
    mkdir -p "$logs"
    local log=$logs/$name.log
    : >"$log"
    # A process group of its own, so that Ctrl-C can end all of it (make and its compilers too).
    set -m
    "$@" >"$log" 2>&1 </dev/null &
    set +m
    local pid=$! start=$SECONDS shown=0
    trap 'kill -- -"$pid" 2>/dev/null; wait "$pid" 2>/dev/null; say "interrupted; run the same command again to go on"; exit 130' INT TERM
    while kill -0 "$pid" 2>/dev/null; do
        sleep 0.5
        local elapsed=$((SECONDS - start))
        if [ -t 2 ]; then
            printf '\r\033[K  %s: %d s, %d lines of log' "$name" "$elapsed" "$(wc -l <"$log")" >&2
        elif [ $((elapsed - shown)) -ge 60 ]; then
            shown=$elapsed
            say "$name: $elapsed s, $(wc -l <"$log") lines of log"
        fi
    done
    [ -t 2 ] && printf '\r\033[K' >&2
    local status=0
    wait "$pid" || status=$?
    trap - INT TERM
    if [ "$status" -ne 0 ]; then
        tail -n 25 "$log" >&2
        fail "$name failed (exit $status) after $((SECONDS - start)) s; the whole log is $log"
    fi
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages() {
    local wanted missing
    wanted=$(grep -v '^#' "$setup/packages.txt")
    # shellcheck disable=SC2086
    missing=$(comm -23 <(sort <<<"$wanted") \
        <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null |
            sed -n 's/^installed //p' | sort -u))
    [ -z "$missing" ] && return
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        fail "these Debian packages are missing: $(tr '\n' ' ' <<<"$missing"); install them as root, or install sudo"
    fi
    say "installing $(wc -l <<<"$missing") Debian packages (usually 1 to 3 minutes)"
    logged package-lists as_root apt-get update
    # shellcheck disable=SC2086
    logged packages as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y --no-install-recommends $missing
}

build_tracer() {
    # One at a time on a machine; the second finds the work done.
    mkdir -p "$cache"
    exec 9>"$cache/lock"
    flock 9
    "$setup/build_tracer.sh"
    exec 9>&-
}

# build_project PRESET [TARGET...]: configures and builds one of CMakePresets.json.
build_project() {
    local preset=$1
    shift
    local build=$project/build/$preset
    if [ ! -f "$build/build.ninja" ]; then
        say "configuring the $preset build (usually 5 seconds)"
        logged "configure-$preset" cmake -S "$project" --preset "$preset" \
            -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
    fi
    if ! ninja -C "$build" -n "$@" 2>/dev/null | grep -q 'no work to do'; then
        say "building povpreview, $preset (usually 2 to 4 minutes when new)"
        logged "build-$preset" ninja -C "$build" "$@"
    fi
    ln -sfn "$("$setup/build_tracer.sh" --where)" "$build/povpreview-tracer"
}
