// The integers of core/Hash.h.

uint hash32(uint x) {
  x ^= x >> 16;
  x *= 0x21f0aaadu;
  x ^= x >> 15;
  x *= 0x735a2d97u;
  x ^= x >> 15;
  return x;
}

uint hashNode(ivec3 n, uint seed) {
  return hash32(uint(n.x) * 0x8da6b343u ^ uint(n.y) * 0xd8163841u ^ uint(n.z) * 0xcb1ab31fu ^ seed);
}
