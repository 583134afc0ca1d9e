# SPDX-License-Identifier: AGPL-3.0-or-later
#
# For benches to source: where scenes are. REQUIRES: out, the folder for results, which is made.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
examples=/usr/share/doc/povray/examples
mkdir -p "$out"
out=$(realpath "$out")

# A scene as lists name it: POV-Ray's by folder and name, ours by name alone.
scene_path() {
    case $1 in
    */*) echo "$examples/$1" ;;
    *) echo "$here/../../scenes/$1" ;;
    esac
}
