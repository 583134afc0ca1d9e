#!/usr/bin/env bash
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# build_tracer.sh          fetches Debian's source of POV-Ray, applies patches/ and builds the tracer
# build_tracer.sh --where  prints the path of the tracer that belongs to this checkout
#
# What is built is named after a hash of everything it is made of, so it is built again exactly when
# something of that changes, and clones of equal content share it.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

version=1:3.7.0.10-2
upstream=3.7.0.10

hash=$(cd "$project" && { echo "$version" && cat adapter/setup/build_tracer.sh &&
    find patches adapter/tracer adapter/wire.fbs -type f | LC_ALL=C sort | xargs tail -n +1; } |
    sha256sum | cut -c1-16)
binary=$cache/tracer-$hash/povray

if [ "${1:-}" = --where ]; then
    echo "$binary"
    exit
fi
[ -x "$binary" ] && exit

# Debian's source package, by deb-src lines made from the machine's own lists; those stay untouched.
fetch() {
    local apt=$cache/apt codename
    codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
    rm -rf "$apt/parts" && mkdir -p "$apt/parts" "$apt/lists/partial" "$cache/source"
    # Only the distribution's own suites: other archives on this machine need not carry sources.
    shopt -s nullglob
    local list
    for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [ ! -f "$list" ] || sed -nE \
            "s/^deb ((\[[^]]*\] +)?[^ ]+ +$codename([-\/][a-z]+)? .*)/deb-src \1/p" "$list"
    done >"$apt/parts/source.list"
    for list in /etc/apt/sources.list.d/*.sources; do
        awk -v RS= -v ORS='\n\n' -v suite="\nSuites:[^\n]* $codename([-/ \n])" \
            '("\n" $0 "\n") ~ suite' "$list" | sed -E 's/^Types:.*/Types: deb-src/'
    done >"$apt/parts/source.sources"
    local options=(-o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$apt/parts"
        -o Dir::State::lists="$apt/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache=
        -o APT::Sandbox::User="$(id -un)")
    apt-get "${options[@]}" update
    (cd "$cache/source" && apt-get "${options[@]}" source --download-only "povray=$version")
    touch "$cache/source/fetched-$upstream"
}

unpack() {
    rm -rf "$tree"
    dpkg-source -x "$cache/source/povray_${version#*:}.dsc" "$tree"
    cd "$tree"
    if [ -s "$project/patches/series" ]; then
        QUILT_PATCHES=$project/patches QUILT_PC=.pc-povpreview quilt --quiltrc=- push -a
    fi
    # Our end of the wire is compiled as one more folder of POV-Ray's back end.
    mkdir -p source/backend/oracle
    cp "$project"/adapter/tracer/*.h "$project"/adapter/tracer/*.cpp source/backend/oracle/
    flatc --cpp -o source/backend/oracle "$project/adapter/wire.fbs"
}

# The steps of debian/rules, less what the tracer does without (X11, SDL).
configure() {
    cd "$tree"
    (
        cd unix/config
        for macro in *.m4; do
            if [ ! -h "$macro" ] && [ -f "/usr/share/aclocal/$macro" ]; then
                mv "$macro" "$macro.dist" && ln -s "/usr/share/aclocal/$macro"
            fi
        done
    )
    mv libraries libraries.donotuse
    (cd unix && ./prebuild.sh)
    # The optimisation of Debian's build, so that floating point gives the same bits.
    ./configure --prefix=/usr --sysconfdir=/etc --disable-optimiz --disable-strip \
        --with-boost-thread=boost_thread --without-x --without-libsdl \
        COMPILED_BY=povpreview CXX="ccache g++" CXXFLAGS="-O3 -g0 -w"
}

build() {
    cd "$tree"
    make -j"$(nproc)"
}

tree=$cache/build-$hash/povray-$upstream
mkdir -p "$cache/build-$hash"
if [ ! -f "$cache/source/fetched-$upstream" ]; then
    say "fetching Debian's source of POV-Ray $upstream (53 MB, usually 10 seconds)"
    logged fetch-povray fetch
fi
if [ ! -f "$cache/build-$hash/configured" ]; then
    say "unpacking, patching and configuring POV-Ray (usually 1 minute)"
    logged unpack-povray unpack
    logged configure-povray configure
    touch "$cache/build-$hash/configured"
fi
say "building the tracer from POV-Ray (usually 5 to 9 minutes the first time on 2 cores, seconds after small changes)"
logged build-povray build
mkdir -p "$cache/tracer-$hash"
cp "$tree/unix/povray" "$cache/tracer-$hash/povray.new"
strip "$cache/tracer-$hash/povray.new"
mv "$cache/tracer-$hash/povray.new" "$binary"
rm -rf "$cache/build-$hash"
say "the tracer is ready: $binary"
