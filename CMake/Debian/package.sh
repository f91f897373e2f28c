# shellcheck shell=bash
package() { die "not yet"; }
