# The Debian packages that building, testing and checking take, and how they are installed. Sourced by the scripts.

# openimageio-tools: OpenImageIO's CMake files want its programs to be there.
build_packages=(g++ cmake ninja-build pkg-config
  libopenimageio-dev openimageio-tools libopencolorio-dev libopencv-dev libopencv-contrib-dev libtbb-dev
  libeigen3-dev zlib1g-dev libseccomp-dev libdeflate-dev libopenexr-dev liblcms2-dev libssl-dev
  libfmt-dev nlohmann-json3-dev libcli11-dev libglm-dev
  libglfw3-dev libimgui-dev libepoxy-dev libegl-dev libgl-dev libgl1-mesa-dri libegl1 libfreetype-dev
  fonts-inter fonts-material-design-icons-iconfont)
test_packages=(libgtest-dev libgmock-dev librapidcheck-dev python3 python3-numpy python3-openimageio xvfb xdotool python3-xlib)
check_packages=(git clang clang-format clang-tidy)
# libc6-dbg: the thread sanitizer's suppressions name a function of the C library.
sanitize_packages=(libc6-dbg)
fuzz_packages=(clang-14 clang libclang-rt-14-dev libfuzzer-14-dev)
fresh_packages=(mmdebstrap git)

# Installs those of the packages named that are missing.
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
  local as_root=(env DEBIAN_FRONTEND=noninteractive)
  [ "$(id -u)" -eq 0 ] || as_root=(sudo "${as_root[@]}")
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
}
