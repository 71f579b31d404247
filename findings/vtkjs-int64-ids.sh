#!/usr/bin/env bash
# vtk.js 37.4.3 reads Int64 arrays of a .vtp file into 32 bits and keeps the low half of each value, without a message:
# particle ids from 2^31 on become negative, and ids that differ by 2^32 become equal.
#
# Seen on Node.js 20 with the file below (valid VTK XML, ids 7, 3000000000 and 4294967303):
#     Int32Array 7 -1294967296 7
# VTK itself and ParaView keep all 64 bits. Where it hurts: codes that put a rank or a marker into the high half of an id
# (a common way to number particles in parallel) and viewers in the browser that select or colour by it.
# Source: integer64to32 in IO/XML/XMLReader of the package. wetdeck numbers particles from 0: its ids fit.
#
# Needs node and npm. Ends with 0 while the behaviour is as described, with 1 once it has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
echo '{"type": "module", "private": true}' >package.json
npm install --ignore-scripts --no-audit --no-fund --silent @kitware/vtk.js@37.4.3
cat >read.mjs <<'SCRIPT'
import reader from '@kitware/vtk.js/IO/XML/XMLPolyDataReader.js';

const base64 = (bytes) => {
  const length = Buffer.alloc(4);
  length.writeUInt32LE(bytes.length);
  return Buffer.concat([length, bytes]).toString('base64');
};
const ids = Buffer.alloc(24);
[7n, 3000000000n, 4294967303n].forEach((id, k) => ids.writeBigInt64LE(id, 8 * k));
const file = `<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt32"><PolyData>
<Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<PointData><DataArray type="Int64" Name="id" format="binary">${base64(ids)}</DataArray></PointData>
<Points><DataArray type="Float32" Name="Points" NumberOfComponents="3" format="binary">${base64(Buffer.alloc(36))}</DataArray></Points>
</Piece></PolyData></VTKFile>`;
const instance = reader.newInstance();
instance.parseAsArrayBuffer(new TextEncoder().encode(file).buffer);
const array = instance.getOutputData(0).getPointData().getArrayByName('id');
console.log(array.getDataType(), Array.from(array.getData()).join(' '));
SCRIPT
seen=$(node read.mjs)
echo "vtk.js 37.4.3: $seen"
[ "$seen" = "Int32Array 7 -1294967296 7" ] || { echo "the behaviour has changed"; exit 1; }
