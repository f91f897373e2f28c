# shellcheck shell=bash
# ./dev fresh: runs a command as a stranger would, on a minimal Debian that has nothing installed.
# Sourced by ./dev. A root is made by debootstrap once, kept, and copied for each run.

fresh_usage()
{
  cat <<END
usage: ./dev fresh [OPTION...] [SUITE [COMMAND...]]

Makes a minimal root of Debian SUITE (bookworm, trixie, forky; default bookworm), puts a clean clone
of HEAD in it and runs COMMAND there (default ./dev demo), in name spaces of its own. Needs root,
debootstrap and a mirror. Exit status: that of COMMAND; 77 where no root can be made.

  --user          as a user with neither root nor sudo: COMMAND has to ask for its packages in one
                  apt-get line; that line is run by root, then COMMAND again
  --folder NAME   the clone's folder, default SubdivisionObjects; try one with a space
  --keep          keep the root, to look into; a later run with --again goes on in it
  --cache         take what was compiled before on this system, from the same sources (build/ccache), where the suite is the same
  --again         in the kept root, with its clone brought up to HEAD
  --record        put the result into the table of Documentation/Platforms.md

Everything stands in build/fresh/SUITE: log, pictures of the demo, packages. The mirror is the one
that apt uses on this system; DEBIAN_MIRROR and DEBIAN_SECURITY_MIRROR override it.
END
}

fresh() # [OPTION...] [SUITE [COMMAND...]]
{
  local user=root folder=SubdivisionObjects keep=no again=no record=no caches=no cache="" suite
  while [[ "${1:-}" == -* ]]; do
    case $1 in
      --user) user=visitor ;;
      --folder) folder=${2:?}; shift ;;
      --keep) keep=yes ;;
      --again) again=yes ;;
      --cache) caches=yes ;;
      --record) record=yes ;;
      --help) fresh_usage; return 0 ;;
      *) fresh_usage >&2; return 2 ;;
    esac
    shift
  done
  suite=${1:-bookworm}
  [ $# -eq 0 ] || shift
  [ $# -gt 0 ] || set -- ./dev demo
  package_lists "$suite" || die "no such suite: $suite (bookworm, trixie, forky)"
  not_checked_without root debootstrap unshare git

  place=$build/fresh/$suite
  mkdir -p "$place/archives/partial" "$place/pictures"
  target=$place/root
  if [ $again = no ]; then
    fresh_base "$suite"
    rm -rf "$target"
    cp -a --reflink=auto "$place/base" "$target"
  fi
  [ -d "$target" ] || die "no root is kept in $target"
  fresh_clone
  if [ $caches = yes ]; then
    cache=$build/ccache
    mkdir -p "$cache" "$target/ccache"
    fresh_inside root / env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends ccache >>"$place/base.log" 2>&1 || cache=""
  fi

  local log started seconds before status=0
  log=$place/$(fresh_slug "$@").log
  say "fresh $suite as $user, in a folder named '$folder': $*"
  before=$(fresh_disk)
  started=$SECONDS
  if [ "$user" = root ]; then
    fresh_run "$@" 2>&1 | tee "$log" || status=$?
  else
    fresh_run_as_user "$log" "$@" || status=$?
  fi
  seconds=$((SECONDS - started))
  cp "$target/$home/$folder"/build/demo/*.png "$place/pictures/" 2>/dev/null || true
  if [ -d "$target/$home/$folder/build/packages" ]; then
    rm -rf "$place/packages"
    cp -a "$target/$home/$folder/build/packages" "$place/packages"
    chown -R root: "$place/packages"
  fi
  fresh_report "$@"
  [ $keep = yes ] || rm -rf "$target"
  return $status
}

# What cannot be checked must not look as if it had passed.
not_checked_without() # root|COMMAND...
{
  local what missing=()
  for what in "$@"; do
    if [ "$what" = root ]; then
      [ "$(id -u)" = 0 ] || missing+=("root")
    else
      command -v "$what" >/dev/null || [ -x "/usr/sbin/$what" ] || missing+=("$what")
    fi
  done
  # Root can help itself to a package.
  if [ "${missing[*]}" = debootstrap ] && [ $install = yes ] && command -v apt-get >/dev/null; then
    need debootstrap
    missing=()
  fi
  [ ${#missing[@]} -eq 0 ] || cannot_check "missing here: ${missing[*]}"
}

cannot_check() { say "fresh machine: not checked: $*"; exit 77; }

# ---------------------------------------------------------------- the root

# repository LABEL: where apt of this system finds Debian (or Debian-Security).
repository()
{
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' "Label: $1" 2>/dev/null | sort -u | head -n 1
}

# fresh_base SUITE: a minimal root, made once, brought up to date when it is older than a day.
fresh_base()
{
  local base=$place/base mirror security script
  # shellcheck disable=SC2012
  if [ -e "$base/ready" ] && [ -z "$(find "$base/ready" -mmin +1440)" ]; then
    return 0
  fi
  mirror=${DEBIAN_MIRROR:-$(repository Debian)}
  security=${DEBIAN_SECURITY_MIRROR:-$(repository Debian-Security)}
  [ -n "$mirror" ] || cannot_check "apt of this system knows no Debian mirror: set DEBIAN_MIRROR and DEBIAN_SECURITY_MIRROR"
  if [ ! -e "$base/ready" ]; then
    say "making a minimal root of $suite (log: $place/base.log)"
    rm -rf "$base"
    script=()
    [ -e "/usr/share/debootstrap/scripts/$suite" ] || script=(/usr/share/debootstrap/scripts/sid)
    debootstrap --variant=minbase "$suite" "$base" "$mirror" "${script[@]}" >"$place/base.log" 2>&1 ||
      { tail -n 20 "$place/base.log" >&2; cannot_check "debootstrap failed, see $place/base.log"; }
    printf '%s\n' "deb $mirror $suite main" "deb $mirror $suite-updates main" \
      ${security:+"deb $security $suite-security main"} >"$base/etc/apt/sources.list"
  fi
  target=$base fresh_inside root / bash -c "$(declare -f fresh_update); fresh_update" >>"$place/base.log" 2>&1 ||
    { tail -n 20 "$place/base.log" >&2; cannot_check "the root cannot be brought up to date, see $place/base.log"; }
  touch "$base/ready"
}

# Runs inside. A mirror that stands still for some weeks is said to be expired; its packages are signed all the same.
fresh_update()
{
  export DEBIAN_FRONTEND=noninteractive
  if ! apt-get update -qq -o APT::Update::Error-Mode=any; then
    echo 'Acquire::Check-Valid-Until "false";' >/etc/apt/apt.conf.d/80old-mirror
    apt-get update -qq -o APT::Update::Error-Mode=any
  fi
  # Nobody misses a root that is lost with the power: its packages need not wait for the disk.
  echo force-unsafe-io >/etc/dpkg/dpkg.cfg.d/80fresh
  apt-get upgrade -y -qq
  id visitor >/dev/null 2>&1 || useradd --create-home --shell /bin/bash visitor
}

# A clean clone of HEAD, as somebody who downloads the project has it.
fresh_clone()
{
  home=root
  [ "$user" = root ] || home=home/$user
  local clone=$target/$home/$folder
  [ -z "$(git -C "$root" status --porcelain)" ] || say "note: what is not committed is not in the clone"
  if [ -d "$clone" ]; then
    # It may belong to the visitor.
    git -c safe.directory="$clone" -C "$clone" fetch --quiet "$root" HEAD
    git -c safe.directory="$clone" -C "$clone" reset --quiet --hard FETCH_HEAD
  else
    git clone --quiet --no-hardlinks "$root" "$clone"
  fi
  chown -R --reference="$target/$home" "$clone"
}

# fresh_inside USER FOLDER COMMAND...: in the root, as USER. The mounts belong to a name space and
# go with it; processes that COMMAND leaves behind are ended with it.
fresh_inside()
{
  unshare --mount --pid --fork --kill-child --propagation private -- \
    bash -c "$(declare -f enter_root); enter_root \"\$@\"" enter "$target" "$place/archives" "${JOBS:-}" "${cache:-}" "$@"
}

enter_root() # ROOT ARCHIVES JOBS CACHE USER FOLDER COMMAND...
{
  set -euo pipefail
  local root=$1 archives=$2 jobs=$3 cache=$4 user=$5 folder=$6
  shift 6
  mount -t proc proc "$root/proc"
  mount --bind /sys "$root/sys"
  mount -o remount,bind,ro "$root/sys"
  mount -t tmpfs -o mode=1777 shm "$root/dev/shm"
  mount -t devpts -o newinstance,ptmxmode=0666,mode=0620,gid=5 devpts "$root/dev/pts" 2>/dev/null || true
  mount --bind "$archives" "$root/var/cache/apt/archives"
  [ -z "$cache" ] || mount --bind "$cache" "$root/ccache"
  cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  exec env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM=dumb ${jobs:+JOBS="$jobs"} ${cache:+COMPILER_CACHE=/ccache} \
    chroot "$root" bash -c 'user=$1 folder=$2; shift 2; cd "$folder"; export HOME=~
      [ "$user" = root ] && exec "$@"; export HOME=/home/$user USER=$user
      exec setpriv --reuid="$user" --regid="$user" --init-groups "$@"' inside "$user" "$folder" "$@"
}

fresh_run() { fresh_inside "$user" "/$home/$folder" "$@"; }

# fresh_run_as_user LOG COMMAND...: what is missing has to be asked for in one line, which root then runs.
fresh_run_as_user()
{
  local log=$1 line
  shift
  if fresh_run "$@" 2>&1 | tee "$log"; then
    return 0
  fi
  line=$(sed -n 's/^ *sudo \(apt-get install .*\)/\1/p' "$log" | tail -n 1)
  [ -n "$line" ] || { say "it did not ask for packages by one line 'sudo apt-get install ...'"; return 1; }
  say "as root: $line"
  # shellcheck disable=SC2086
  fresh_inside root / env DEBIAN_FRONTEND=noninteractive bash -c "apt-get update -qq && $line -y -qq" >>"$log" 2>&1 || return 1
  fresh_run "$@" 2>&1 | tee -a "$log"
}

# ---------------------------------------------------------------- what came out

fresh_slug() { printf '%s' "$*${user/root/}${folder/SubdivisionObjects/}" | tr -cs 'A-Za-z0-9' '-' | cut -c1-100 | sed 's/^-*//; s/-*$//'; }

fresh_disk() { du -sm --exclude=archives "$target" | cut -f1; }

fresh_report() # COMMAND...
{
  local result=passed counts who versions row table=$root/Documentation/Platforms.md
  counts=$(grep -E '^[0-9]+ passed, [0-9]+ failed' "$log" | tail -n 1 || true)
  [ $status = 0 ] || result="failed ($status)"
  who=$user
  [ "$user" = root ] || who="no root"
  [ "$folder" = SubdivisionObjects ] || who+=", folder \"$folder\""
  versions=$(fresh_versions)
  row="| $suite | \`$*\` | $who | $result${counts:+: $counts} | $((seconds / 60)) min $((seconds % 60)) s | $(($(fresh_disk) - before)) MB |"
  say "$row $versions"
  printf '%s\n' "$row" >"${log%.log}.row"
  [ $record = yes ] && record_row "$table" "$row"
  return 0
}

# The table, the only one of six columns, is kept sorted, one row for each suite, command and user.
record_row() # FILE ROW
{
  local key
  key=$(cut -d'|' -f2-4 <<<"$2")
  { (grep '^| [a-z]* | `' "$1" || true) | (grep -vF "|$key|" || true); printf '%s\n' "$2"; } | LC_ALL=C sort >"$1.rows"
  sed -i -e '/^| [a-z]* | `/d' -e "/^|---|---|---|---|---|---|\$/r $1.rows" "$1"
  rm "$1.rows"
}

fresh_versions()
{
  local package version list=""
  for package in g++ cmake "libvtk$vtk_version" paraview; do
    version=$(dpkg-query --admindir="$target/var/lib/dpkg" -W -f '${Version}' "$package" 2>/dev/null || true)
    [ -z "$version" ] || list+="${list:+, }${package/lib/} $(sed -E 's/^[0-9]+://; s/[-+].*//' <<<"$version")"
  done
  echo "$list"
}
