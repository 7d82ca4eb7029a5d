#!/usr/bin/env bash
# What action.yml runs: robodyn build --check of the project FILE, its counts compared with the lock file of the
# revision AGAINST (if any); the report goes to the summary of the job, and to the file JUNIT (if any).
set -euo pipefail

arguments=(--check --file "$FILE")
if [ -n "$AGAINST" ]; then
    base=$(mktemp)
    git cat-file -e "$AGAINST^{commit}" 2>/dev/null || git fetch --quiet --depth=1 origin "$AGAINST"
    revision=$(git rev-parse --quiet --verify "$AGAINST^{commit}" || git rev-parse FETCH_HEAD)
    if git show "$revision:./${FILE%.toml}.lock" >"$base" 2>/dev/null; then
        arguments+=(--against "$base")
    else
        echo "robodyn: note: $AGAINST has no lock file to compare with" >&2
    fi
fi
report=$(mktemp)
status=0
robodyn build "${arguments[@]}" --format markdown --output "$report" || status=$?
cat "$report" >>"${GITHUB_STEP_SUMMARY:-/dev/null}"
if [ -n "$JUNIT" ]; then
    robodyn build "${arguments[@]}" --format junit --output "$JUNIT" >/dev/null 2>&1 || true
fi
exit "$status"
