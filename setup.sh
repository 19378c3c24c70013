#!/bin/sh
# Installs the system packages that building, running and testing Cardiomorph need, and only those that are missing.
# Works with apt, dnf and pacman; elsewhere it prints what to install. Running it again does nothing.
set -eu

say() { printf 'setup: %s\n' "$*"; }

# Packages by purpose: a C linker to build; X11, keyboard and Vulkan libraries to run; Mesa's drivers, which also
# draw without a graphics card; OpenGL as the way out where Vulkan is missing; D-Bus for file dialogs.
apt_packages="gcc libc6-dev libx11-6 libx11-xcb1 libxcursor1 libxi6 libxkbcommon0 libxkbcommon-x11-0 libwayland-client0 \
libvulkan1 mesa-vulkan-drivers libegl1 libgl1-mesa-dri libdbus-1-3"
dnf_packages="gcc glibc-devel libX11 libX11-xcb libXcursor libXi libxkbcommon libxkbcommon-x11 libwayland-client \
vulkan-loader mesa-vulkan-drivers libglvnd-egl mesa-dri-drivers dbus-libs"
pacman_packages="gcc glibc libx11 libxcursor libxi libxkbcommon libxkbcommon-x11 wayland \
vulkan-icd-loader vulkan-swrast libglvnd mesa dbus"

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null 2>&1; then
        say "asks for your password to run: $*"
        sudo "$@"
    else
        say "needs root for: $*"
        say "run this script as root, or install sudo"
        exit 1
    fi
}

# Prints those of the named packages that are not installed.
missing() {
    probe=$1
    shift
    for package in "$@"; do
        $probe "$package" >/dev/null 2>&1 || printf '%s ' "$package"
    done
}

# One call for all packages: asking one by one takes over a second.
apt_missing() {
    installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | sed -n 's/ installed$//p') || true
    for package in "$@"; do
        printf '%s\n' "$installed" | grep -qx "$package" || printf '%s ' "$package"
    done
}

# A file dialog needs a desktop portal, or zenity. Without a display nobody opens a dialog.
dialog_helper() {
    [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || return 0
    command -v zenity >/dev/null 2>&1 && return 0
    for folder in /usr/libexec /usr/lib /usr/lib/xdg-desktop-portal; do
        [ -x "$folder/xdg-desktop-portal" ] && return 0
    done
    echo zenity
}

if command -v apt-get >/dev/null 2>&1; then
    # shellcheck disable=SC2046,SC2086
    wanted=$(apt_missing $apt_packages $(dialog_helper))
    if [ -n "$wanted" ]; then
        say "installs with apt: $wanted"
        as_root apt-get update -qq
        # shellcheck disable=SC2086
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $wanted
    fi
elif command -v dnf >/dev/null 2>&1; then
    # shellcheck disable=SC2046,SC2086
    wanted=$(missing "rpm -q" $dnf_packages $(dialog_helper))
    if [ -n "$wanted" ]; then
        say "installs with dnf: $wanted"
        # shellcheck disable=SC2086
        as_root dnf install -y --quiet $wanted
    fi
elif command -v pacman >/dev/null 2>&1; then
    # shellcheck disable=SC2046,SC2086
    wanted=$(missing "pacman -Qi" $pacman_packages $(dialog_helper))
    if [ -n "$wanted" ]; then
        say "installs with pacman: $wanted"
        # shellcheck disable=SC2086
        as_root pacman -S --needed --noconfirm $wanted
    fi
else
    say "does not know this system's package manager. Please install by hand:"
    say "  a C compiler; libraries X11, Xcursor, Xi, xkbcommon with its X11 part, Wayland client, EGL, D-Bus;"
    say "  the Vulkan loader and a driver (Mesa's lavapipe draws without a graphics card)."
    say "On Debian these are: $apt_packages"
    exit 1
fi

if ! command -v cargo >/dev/null 2>&1; then
    say "system packages are in place, but Rust is missing: install Rust 1.95 or later with rustup, then go on"
    exit 1
fi
say "everything is in place"
