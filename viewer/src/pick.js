// SPDX-License-Identifier: Apache-2.0
// What a click meets: the nearest surface or point that is shown and not cut away.

// Returns {unit: [kind, id, element], place} or null.
export function pick(view, parts, shown, x, y) {
  const caster = view.ray(x, y), found = [];
  const visible = (place) => view.planes.every((plane) => plane.distanceToPoint(place) >= 0);
  const meet = (object, unitOf, prefer = 0) => {
    object.updateMatrixWorld(true);
    for (const hit of caster.intersectObject(object, false))
      if (visible(hit.point)) { found.push({ distance: hit.distance - prefer, unit: unitOf(hit), place: hit.point }); break; }
  };
  if (shown.buildings && parts.buildings)
    for (const mesh of parts.buildings.object.children)
      if (mesh.isMesh) meet(mesh, (hit) => ['building', parts.buildings.table.id[mesh.userData.rows[hit.faceIndex]]]);
  if (shown.facades && parts.facades) {
    // Elements lie on the outline of their facade; of faces at one place the element counts.
    const hits = caster.intersectObject(parts.facades.target, false).filter((hit) => visible(hit.point));
    if (hits.length > 0) {
      const of = (hit) => parts.facades.target.userData.of[hit.faceIndex];
      const near = hits.filter((hit) => hit.distance < hits[0].distance + 0.5).sort((a, b) => of(b)[2] - of(a)[2] || a.distance - b.distance)[0];
      const [id, element, inside] = of(near);
      found.push({ distance: hits[0].distance - 0.3, unit: inside ? ['facade', id, element] : ['facade', id], place: near.point });
    }
  }
  if (shown.objects && parts.street) meet(parts.street.mesh, (hit) => ['object', parts.street.list[hit.instanceId][0]], 0.3);
  if (shown.planes && parts.planes?.mesh) meet(parts.planes.mesh, (hit) => ['plane', parts.planes.mesh.userData.ids[hit.faceIndex]]);
  if (shown.points && parts.points) {
    const i = parts.points.nearest(view.camera, view.canvas.clientWidth, view.canvas.clientHeight, x, y, view.planes);
    if (i >= 0) {
      const place = parts.points.at(i);
      found.push({ distance: place.distanceTo(view.camera.position), unit: unitOfPoint(parts.points, i), place, point: i });
    }
  }
  found.sort((a, b) => a.distance - b.distance);
  return found[0] ?? null;
}

// The unit that a point belongs to: what it was found for first.
function unitOfPoint({ columns, way }, i) {
  const building = columns.unit?.[i] ? ['unit', columns.unit[i]] : null;
  const plane = columns.plane?.[i] ? ['plane', columns.plane[i]] : null;
  if ((way === 'plane' || way === 'residual') && plane) return plane;
  if (columns.object?.[i]) return ['object', columns.object[i]];
  if (columns.facade?.[i]) return columns.element?.[i] > 1 ? ['facade', columns.facade[i], columns.element[i]] : ['facade', columns.facade[i]];
  return building ?? plane;
}
