#!/usr/bin/env bash
# udunits2 2.2.28 reads several units of ships as other units, without a message: an SI prefix in front of a shorter symbol
# wins, and "ton" is that of the United States.
#
# Seen with the program udunits2 of Debian 12 (2.2.28-5):
#     nmi    1.609344e-06 m            a nano-mile; the nautical mile is "nautical_mile" or "nmile"
#     fm     1e-15 m                   a femtometre; the fathom is "fathom"
#     mH2O   9.80665 m-2.kg.s-2         a thousandth of the weight of water per volume, no pressure; "cmH2O", which has an entry
#                                      of its own, is 98.0665 Pa, and "m H2O" 9806.65 Pa
#     PS     1e+15 m-2.kg-1.s3.A2       a petasiemens, not the metric horsepower
#     ton    907.18474 kg              the short ton; "t" and "tonne" are 1000 kg, "long_ton" 1016 kg
# Where it hurts: measuring records of towing tanks, cargo and loads in whose headings these symbols are common. In the first two
# and the last case the dimension is right, so that a check of dimensions passes. Source: the tables of prefixes and accepted units
# that come with the library. wetdeck refuses the first three and the last by name.
#
# Needs apt-get (to download, not to install) and dpkg. Ends with 0 while the behaviour is as described, with 1 once it has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
chmod 755 "$folder"
cd "$folder"
apt-get download -qq udunits-bin=2.2.28-5 libudunits2-0=2.2.28-5 libudunits2-data=2.2.28-5 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
library=$(dirname "$(find usr/lib -name 'libudunits2.so.0' | head -1)")
export LC_ALL=C LD_LIBRARY_PATH="$PWD/$library" UDUNITS2_XML_PATH="$PWD/usr/share/xml/udunits/udunits2.xml"
status=0
while read -r unit expected; do
    seen=$(usr/bin/udunits2 -H "$unit" -W "" </dev/null 2>&1 | tr -d '\n' | sed 's/^ *//; s/ *$//')
    echo "udunits2 2.2.28: $unit is $seen"
    [ "$seen" = "$expected" ] || { echo "the behaviour has changed, it was $expected"; status=1; }
done <<'UNITS'
nmi 1.609344e-06 m
fm 1e-15 m
mH2O 9.80665 m-2.kg.s-2
cmH2O 98.0665 m-1.kg.s-2
PS 1e+15 m-2.kg-1.s3.A2
ton 907.18474 kg
UNITS
exit $status
