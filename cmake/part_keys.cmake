# The keys of a document, as in dupin/blends/part_shape.h. Each has a file of its name in
# blends/src/assembly/parts (what it means), io/src/json/parts (how it is read) and
# tests/io/json/parts; see docs/extending.md.
set(DUPIN_PART_KEYS
  pipe
  cone
  oblique
  elbow
  sphere
  spline
  cyclic_blend
  two_cone_blend
  ringed_blend
  cyclide_blend
  cyclide_chain
  cap)
