// The Earth divided among cities: the area of each in km², the distances to its neighbours, the place that is
// farthest from all, and the regions as GeoJSON, whose longitudes go on beyond 180° where a region crosses that
// meridian. The cities are a table of names, longitudes and latitudes.
//
//     node cities.mjs cities.csv regions.geojson > neighbours.csv
import { readFile, writeFile } from 'node:fs/promises';
import { load } from 'geodesic-voronoi';

const [table, output = 'regions.geojson'] = process.argv.slice(2);
if (!table) throw new Error('usage: node cities.mjs TABLE [OUTPUT]');
const [header, ...lines] = (await readFile(table, 'utf8')).trim().split('\n');
if (!/,\W*l(on|ng)[^,]*,\W*lat[^,]*$/i.test(header))
  throw new Error(`the first line of ${table} is no list of name,longitude,latitude: ${header}`);
const cities = lines.map((line) => line.match(/^(.*),([^,]*),([^,]*)$/).slice(1));
if (cities.length < 2) throw new Error(`${table} has no two cities below its first line`);

const gvd = await load();
// Any mesh will do, also with relief, whose origin is the centre of the Earth and whose z axis is its own.
const mesh = await gvd.mesh(globe(6371, 100));
const places = cities.flatMap(([, longitude, latitude]) => placeOf(longitude, latitude));
const { face, bary } = await mesh.closestPoints(places);
const diagram = await mesh.voronoi({ face, bary });
const { points } = diagram.data;
const positionOf = (point) => points.position.subarray(3 * point, 3 * point + 3);

const site = (label) => ({ face: face[label], bary: bary.subarray(3 * label, 3 * label + 3) });
console.log('city,area,neighbour,distance');
for (const { label, area, neighbours } of diagram.regions)
  for (const neighbour of neighbours) {
    const { length } = await mesh.path(site(label), site(neighbour));
    const names = [label, neighbour].map((each) => cities[each][0]);
    console.log(`${names[0]},${area.toFixed()},${names[1]},${length.toFixed(1)}`);
  }

// On a sphere that is a point of an outline; with three cities or more, a Voronoi point.
const { distance } = await diagram.locate(points);
const farthest = distance.reduce((best, d, i) => (d > distance[best] ? i : best), 0);
const [longitude, latitude] = degreesOf(positionOf(farthest)).map((angle) => angle.toFixed(2));
console.error(`farthest: ${distance[farthest].toFixed(1)} km, at ${longitude}, ${latitude}`);

const features = diagram.regions.map(({ label, area, loops }) => ({
  type: 'Feature',
  properties: { name: cities[label][0].replaceAll('"', ''), area },
  geometry: { type: 'Polygon', coordinates: loops.map(ringOf) },
}));
await writeFile(output, JSON.stringify({ type: 'FeatureCollection', features }));
gvd.dispose();

/** An outline in degrees. As GeoJSON asks for, it ends where it begins and has the region on its left. */
function ringOf(loop) {
  const ring = Array.from([...loop, loop[0]], (point) => degreesOf(positionOf(point)));
  for (let i = 1; i < ring.length; ++i)
    ring[i][0] -= 360 * Math.round((ring[i][0] - ring[i - 1][0]) / 360);
  // A region with a pole in it goes on to the pole along one meridian, and back along the same.
  const [first, last] = [ring[0], ring.at(-1)];
  const turns = Math.round((last[0] - first[0]) / 360);
  if (turns !== 0) ring.push([last[0], 90 * turns], [first[0], 90 * turns], first);
  const longitudes = ring.map(([longitude]) => longitude);
  const middle = (Math.min(...longitudes) + Math.max(...longitudes)) / 2;
  const nearest = 360 * Math.round(middle / 360);
  return ring.map(([longitude, latitude]) => [longitude - nearest, latitude]);
}

function placeOf(longitude, latitude) {
  const [u, v] = [longitude, latitude].map((angle) => (angle * Math.PI) / 180);
  return [Math.cos(v) * Math.cos(u), Math.cos(v) * Math.sin(u), Math.sin(v)].map((x) => 6371 * x);
}

function degreesOf([x, y, z]) {
  return [Math.atan2(y, x), Math.atan2(z, Math.hypot(x, y))].map(
    (angle) => (angle * 180) / Math.PI,
  );
}

/** A sphere: an octahedron whose sides are cut into `n` parts, with all corners moved outwards. */
function globe(radius, n) {
  const positions = [];
  for (const signs of [0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
    [0, 1, 2].map((k) => ((i >> k) & 1) * 2 - 1),
  )) {
    const isMirrored = signs[0] * signs[1] * signs[2] < 0;
    const corner = (i, j) => {
      const place = isMirrored ? [j, i, n - i - j] : [i, j, n - i - j];
      return place.map((x, k) => (signs[k] * x * radius) / Math.hypot(...place));
    };
    for (let i = 0; i < n; ++i)
      for (let j = 0; i + j < n; ++j) {
        positions.push(...corner(i, j), ...corner(i + 1, j), ...corner(i, j + 1));
        if (i + j + 1 < n)
          positions.push(...corner(i + 1, j), ...corner(i + 1, j + 1), ...corner(i, j + 1));
      }
  }
  return { positions };
}
