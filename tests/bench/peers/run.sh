#!/bin/sh
# Times our metric and maps and their peers in the same minutes, and prints the ratios.
# Usage: tests/bench/peers/run.sh [FOLDER FOR THE PYTHON ENVIRONMENT]
# Needs cargo, python3 with venv, and the network once (numpy and scikit-learn).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
target=${CARGO_TARGET_DIR:-$root/target}
environment=${1:-$target/peers}
if [ ! -x "$environment/bin/python" ]; then
    python3 -m venv "$environment"
fi
"$environment/bin/python" -c 'import numpy, sklearn' 2>/dev/null ||
    "$environment/bin/pip" install --quiet numpy==2.4.6 scikit-learn==1.9.1
cd "$root"
cargo bench --bench metric --bench map
exec "$environment/bin/python" "$here/peers.py" "$target/criterion"
