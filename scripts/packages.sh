# Installs the Debian packages named by its arguments, if any is missing. Sourced by scripts/demo and scripts/test.

build_packages=(g++ cmake ninja-build pkg-config ccache
  libopenimageio-dev libopencolorio-dev libopencv-dev libopencv-contrib-dev libtbb-dev libeigen3-dev zlib1g-dev libdeflate-dev libopenexr-dev liblcms2-dev libssl-dev
  libfmt-dev nlohmann-json3-dev libcli11-dev libglm-dev
  libglfw3-dev libimgui-dev libstb-dev libepoxy-dev libegl-dev libgl-dev libgl1-mesa-dri libegl1 libfreetype-dev
  fonts-inter fonts-material-design-icons-iconfont)
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev librapidcheck-dev
  python3 python3-numpy python3-openimageio openimageio-tools
  xvfb xdotool python3-xlib x11-utils x11-apps imagemagick)
check_packages=(clang clang-format clang-tidy)

install_packages() {
  local missing=()
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Abbrev}' "$name" 2>/dev/null)" = "ii " ] || missing+=("$name")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    echo "Debian packages: all there."
    return
  fi
  echo "Debian packages: installing ${missing[*]}"
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -q
  DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
}
