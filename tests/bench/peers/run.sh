#!/bin/sh
# Times our metric, paths, maps, Laplace thickness and images and their peers in the same minutes, and prints the ratios.
# Usage: tests/bench/peers/run.sh [FOLDER THAT SHALL HOLD THE PYTHON ENVIRONMENT]
# Needs cargo, python3 (3.11 or later, with venv) and, the first time, the network (NumPy, SciPy, scikit-learn, scikit-image, JAX, PyEzzi, pydicom).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
target=${CARGO_TARGET_DIR:-$root/target}
mkdir -p "$target"
target=$(cd "$target" && pwd)
mkdir -p "${1:-$target}"
environment=$(cd "${1:-$target}" && pwd)/peers
python=$environment/bin/python
packages='numpy==2.4.6 scipy==1.17.1 scikit-learn==1.9.1 jax==0.10.2 pyezzi==1.0.1.post1 scikit-image==0.26.0 pydicom==3.0.2'

if ! "$python" -c 'import jax, numpy, pydicom, pyezzi, scipy, skimage, sklearn' 2>/dev/null; then
    python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' || {
        echo "run.sh: python3 3.11 or later is needed, not $(python3 --version 2>&1)" >&2
        exit 1
    }
    # Begun anew, for an environment that was broken off half-way holds no pip.
    python3 -m venv --clear "$environment"
    # shellcheck disable=SC2086 # several words on purpose
    "$python" -m pip install --quiet --disable-pip-version-check $packages
fi

cd "$root"
begun=$(date +%s)
CARGO_TARGET_DIR=$target cargo bench --bench metric --bench path --bench map --bench medial --bench images -- --quiet --noplot
"$python" -B "$here/peers.py" "$target/criterion" "$begun"
"$python" -B "$here/thickness.py" "$target/criterion" "$begun"
"$python" -B "$here/images.py" "$target/criterion" "$begun" "${CARDIOMORPH_SHARED:-$root/../shared}/data/images/bivme_cine/sax_full"
exec "$python" -B "$here/paths.py" "$target/criterion"
