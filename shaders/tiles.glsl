// Periodic tiles of texture, -127..127, four a word.

layout(std430, binding = 1) readonly buffer Tiles {
  int tileWord[];
};

const int kPatchTile = 6;
const int kTileGap = 64;  // bytes after each row and each plane, see TextureTile

float tileAt(int tile, ivec3 voxel) {
  ivec4 t = frame.tile[tile];
  ivec3 n = voxel & (t.yzw - 1);
  int stepU = t.w + kTileGap, stepV = t.y * stepU + kTileGap;
  int at = t.x + n.y * stepV + n.x * stepU + n.z;
  return float(bitfieldExtract(tileWord[at >> 2], 8 * (at & 3), 8));
}

// Between the eight voxels around a point of the tile of what comes and goes, of unit SD; `step` tells fields apart.
float comesAndGoesBetween(vec3 rest_mm, ivec3 step) {
  vec3 at = carriedBy(frame.patchFromProbe, rest_mm) - kTileRounding_voxels, low = floor(at), share = at - low;
  ivec3 voxel = frame.patchBase.xyz + ivec3(low) + step;
  float sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    ivec3 bit = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    vec3 weight = mix(1.0 - share, share, vec3(bit));
    sum += weight.x * weight.y * weight.z * tileAt(kPatchTile, voxel + bit);
  }
  return sum / 32.0;
}
