// SPDX-License-Identifier: MIT
//
// What `DiagramData.faceLabel` has for faces without one region.

/** No site reaches the face. */
export const unreachable = -1;
/** Several regions share the face. */
export const mixed = -2;
/** The face is not part of the mesh. This is the lowest label. */
export const dropped = -3;
