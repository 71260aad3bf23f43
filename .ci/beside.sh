# To be sourced: commands that run beside others. `beside NAME COMMAND…` starts one with its output in a file; `joined NAME` waits
# for it, prints that output, and ends the script if the command failed. Whatever still runs when the script ends is stopped.
declare -A beside_jobs
beside_logs=$(mktemp -d)

beside() {
    local name=$1
    shift
    # As a group of its own it can be stopped as a whole, and does not ignore Ctrl-C, which tests send.
    set -m
    "$@" < /dev/null > "$beside_logs/$name" 2>&1 &
    set +m
    beside_jobs[$name]=$!
}

joined() {
    local status=0
    wait "${beside_jobs[$1]}" || status=$?
    unset "beside_jobs[$1]"
    echo "== $1"
    cat "$beside_logs/$1"
    [ "$status" = 0 ] || exit "$status"
}

beside_end() {
    local job
    for job in "${beside_jobs[@]}"; do
        kill -- "-$job" 2> /dev/null || true
    done
    rm -rf "$beside_logs"
}
trap beside_end EXIT
