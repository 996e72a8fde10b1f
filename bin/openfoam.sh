# Sourced by the project's scripts: afterwards an OpenFOAM development environment is loaded.
#
# An OpenFOAM environment that is already sourced is used as it is. Otherwise Debian's OpenFOAM 1912
# is installed, and its development tree (headers, wmake, run functions: in no binary package) is made
# once, outside the checkout, from Debian's source package of the same version.
# The place is $CAPSULEFOAM_OPENFOAM, default $HOME/.local/share/capsuleFoam/openfoam-1912.

capsule_fail() { echo "capsuleFoam set-up: error: $*" >&2; return 1; }
capsule_say() { echo "capsuleFoam set-up: $*"; }

# Install the packages named, if any of them is missing
capsule_packages()
{
    local missing
    missing=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' "$@" 2>/dev/null | awk '$1=="ii"{print $2}')
    missing=$(printf '%s\n' "$@" | grep -vxF "$missing" | tr '\n' ' ')
    [ -n "${missing// /}" ] || return 0
    command -v apt-get >/dev/null \
        || { capsule_fail "no apt-get here: install ${missing}by hand, or source your OpenFOAM first"; return 1; }
    [ "$(id -u)" = 0 ] \
        || { capsule_fail "not root, cannot install: ${missing}(as root: apt-get install $missing)"; return 1; }
    capsule_say "installing Debian packages: $missing"
    apt-get -qq update >/dev/null 2>&1 || true
    # shellcheck disable=SC2086
    DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends $missing >/dev/null \
        || { capsule_fail "apt-get could not install: ${missing}(is the network reachable?)"; return 1; }
}

# Debian's source tree of the installed version, made a development tree in $1
capsule_tree()
{
    local tree=$1 work log version
    version=$(dpkg-query -W -f='${source:Version}' openfoam)
    case "$version" in
        1912*) ;;
        *) capsule_fail "Debian's openfoam is $version here; supported: 1912 (Debian 12), or any openfoam.com release from v1912 to v2512 that is sourced first"; return 1 ;;
    esac
    capsule_say "fetching Debian's OpenFOAM $version source tree, once, to $tree"
    mkdir -p "$(dirname "$tree")" && work=$(mktemp -d "$tree.XXXXXX") || return 1
    log=$work/set-up.log
    (
        set -e
        cd "$work"
        mkdir -p lists/partial
        cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null \
            | sed -n 's/^deb /deb-src /p' > debian.list
        apt="apt-get -o Dir::Etc::sourceparts=- -o Dir::State::lists=$work/lists"
        for sources in /etc/apt/sources.list.d/*.sources; do
            [ -f "$sources" ] && { sed 's/^Types:.*/Types: deb-src/' "$sources"; echo; } >> debian.sources
        done
        if [ -s debian.list ]; then apt="$apt -o Dir::Etc::sourcelist=$work/debian.list"
        else apt="$apt -o Dir::Etc::sourcelist=$work/debian.sources"; fi
        $apt update
        $apt --only-source source "openfoam=$version"
    ) >"$log" 2>&1 \
        || { capsule_fail "could not fetch the source package openfoam $version (is the network reachable?); see $log"; return 1; }
    (
        cd "$work"/openfoam-*/ || exit 1
        set +eu
        source etc/bashrc
        mkdir -p "platforms/$WM_OPTIONS"
        lib=$(dirname "$(dpkg -L libopenfoam | grep -m1 '/libOpenFOAM\.so$')")
        ln -s "$lib" "platforms/$WM_OPTIONS/lib" && ln -s /usr/bin "platforms/$WM_OPTIONS/bin" \
            && make -C wmake/src && wmake/wmakeLnIncludeAll src
    ) >>"$log" 2>&1 || { capsule_fail "could not prepare the OpenFOAM tree; see $log"; return 1; }
    mv "$work"/openfoam-*/ "$tree" && rm -rf "$work"
}

# The API number of the OpenFOAM sourced, such as 1912; other branches of OpenFOAM have none.
# Distributions name their versions as they like, so WM_PROJECT_VERSION is only the last resort.
capsule_api()
{
    local api=${FOAM_API:-}
    [ -n "$api" ] || api=$(sed -n 's/^api=//p' "$WM_PROJECT_DIR/META-INFO/api-info" 2>/dev/null)
    [ -n "$api" ] || api=$(expr "${WM_PROJECT_VERSION:-}" : 'v\([0-9][0-9][0-9][0-9]\)' || true)
    echo "$api"
}

capsule_check()
{
    local api supported="the openfoam.com releases v1912 to v2512"
    api=$(capsule_api)
    case "$api" in
        [0-9][0-9][0-9][0-9]) ;;
        *) capsule_fail "OpenFOAM '${WM_PROJECT_VERSION:-}' in $WM_PROJECT_DIR has no API number; supported: $supported"; return 1 ;;
    esac
    [ "$api" -ge 1912 ] \
        || { capsule_fail "OpenFOAM API $api in $WM_PROJECT_DIR is too old; supported: $supported"; return 1; }
    [ "$api" -le 2512 ] \
        || capsule_say "OpenFOAM API $api in $WM_PROJECT_DIR is newer than any tried; supported: $supported" >&2
    command -v wmake >/dev/null \
        || { capsule_fail "OpenFOAM $WM_PROJECT_VERSION is sourced, but has no wmake: install its development package"; return 1; }
    export CAPSULE_EIGEN=${CAPSULE_EIGEN:-/usr/include/eigen3}
    [ -f "$CAPSULE_EIGEN/Eigen/SparseLU" ] || capsule_packages libeigen3-dev
    [ -f "$CAPSULE_EIGEN/Eigen/SparseLU" ] \
        || { capsule_fail "Eigen 3.3 or later is missing: install libeigen3-dev, or set CAPSULE_EIGEN to the directory that holds Eigen/"; return 1; }
}

capsule_environment()
{
    local tree=${CAPSULEFOAM_OPENFOAM:-$HOME/.local/share/capsuleFoam/openfoam-1912}
    export USER=${USER:-$(id -un)}
    if [ -z "${WM_PROJECT_DIR:-}" ]; then
        capsule_packages openfoam libeigen3-dev g++ make flex m4 dpkg-dev || return 1
        [ -d "$tree" ] || capsule_tree "$tree" || return 1
        # OpenFOAM's own scripts neither suit 'set -e' nor 'set -u'
        local flags=$-
        set +eu
        source "$tree/etc/bashrc"
        [[ $flags != *e* ]] || set -e
        [[ $flags != *u* ]] || set -u
        # Needed by mpirun in containers, where everything is root
        if [ "$(id -u)" = 0 ]; then
            export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
        fi
    fi
    capsule_check || return 1
    # Where wmake puts the products; OpenFOAM's module scripts set these
    export CAPSULE_SRC=$(cd "$(dirname "${BASH_SOURCE[0]}")/../src" && pwd)
    # Debug information takes a third of the build's time; other flags, or none:
    # set CAPSULE_FLAGS
    export CAPSULE_FLAGS=${CAPSULE_FLAGS--g0}
    export FOAM_MODULE_APPBIN=${FOAM_MODULE_APPBIN:-$FOAM_USER_APPBIN}
    export FOAM_MODULE_LIBBIN=${FOAM_MODULE_LIBBIN:-$FOAM_USER_LIBBIN}
}

capsule_environment
