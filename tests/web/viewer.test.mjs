// SPDX-License-Identifier: MIT
//
// The viewer's parts that need no browser.

import assert from 'node:assert/strict';
import { suite, test } from 'node:test';
import { load } from 'geodesic-voronoi';
import { Vector3 } from 'three';
import { cornerNormals } from '../../dist/viewer/buffers/corner_normals.js';
import { DiagramSummary } from '../../dist/viewer/buffers/diagram_summary.js';
import { ModelFrame } from '../../dist/viewer/buffers/model_frame.js';
import { RegionColours, toneColour } from '../../dist/viewer/buffers/region_colours.js';
import { sceneArrays } from '../../dist/viewer/buffers/scene_arrays.js';
import { SceneMesh } from '../../dist/viewer/buffers/scene_mesh.js';
import { ModelDrawing } from '../../dist/viewer/drawing/model_drawing.js';
import { setUpAnnouncements } from '../../dist/viewer/element/announcements.js';
import { DensityPaint, greatestDensity } from '../../dist/viewer/model/density_paint.js';
import { hexagonEnergy, rootDensityIntegral } from '../../dist/viewer/session/hexagon_energy.js';
import { LatestTask } from '../../dist/viewer/session/latest_task.js';
import { changeDiagram } from '../../dist/viewer/session/shown_diagram.js';
import { SiteHistory } from '../../dist/viewer/session/site_history.js';
import { stepsBetween, without } from '../../dist/viewer/session/site_step.js';
import { framingOf } from '../../dist/viewer/stage/framing.js';
import { commandOf } from '../../dist/viewer/tools/commands.js';
import { apart, bumpySphere, grid, octahedron, pointAt, torn } from '../wasm/meshes.mjs';

/** As much of a diagram as colouring looks at. */
function adjacency(siteCount, pairs) {
  return { siteCount, arcs: { labels: Int32Array.from(pairs.flat()) } };
}

function everyPair(n) {
  return Array.from({ length: n }, (_, i) => Array.from({ length: i }, (_, j) => [j, i])).flat();
}

function assertNeighboursDiffer(tones, pairs) {
  for (const [a, b] of pairs)
    assert.notEqual(toneColour(tones[a]), toneColour(tones[b]), `${a}, ${b}`);
}

suite('region colours', () => {
  const ids = (n) => Array.from({ length: n }, (_, i) => 100 + i);

  test('neighbours differ, also where all regions meet', () => {
    for (const n of [1, 2, 6, 8, 9, 20]) {
      const tones = new RegionColours().assign(adjacency(n, everyPair(n)), ids(n));
      assertNeighboursDiffer(tones, everyPair(n));
    }
  });

  test('on a sphere the seven tones are enough, and all are used', () => {
    // Rings of sites around a pole, each next to those beside, above and below it.
    const rings = 12;
    const perRing = 17;
    const at = (i, j) => i * perRing + (j % perRing);
    const pairs = [];
    for (let i = 0; i < rings; ++i) {
      for (let j = 0; j < perRing; ++j) {
        pairs.push([at(i, j), at(i, j + 1)]);
        if (i > 0) pairs.push([at(i - 1, j), at(i, j)], [at(i - 1, j + 1), at(i, j)]);
      }
    }
    const n = rings * perRing;
    const tones = new RegionColours().assign(adjacency(n, pairs), ids(n));
    assertNeighboursDiffer(tones, pairs);
    assert.equal(new Set(tones).size, 7);
    assert.ok(Math.max(...tones) < 7);
  });

  /**
   * sRGB as dichromats see it, by another model than the one that colours are chosen by: Viénot, Brettel,
   * Mollon. Digital Video Colourmaps for Checking the Legibility of Displays by Dichromats. 1999.
   */
  const dichromats = {
    nobody: [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
    protanopia: [
      [0.11238, 0.88762, 0],
      [0.11238, 0.88762, 0],
      [0.00401, -0.00401, 1],
    ],
    deuteranopia: [
      [0.29275, 0.70725, 0],
      [0.29275, 0.70725, 0],
      [-0.02234, 0.02234, 1],
    ],
  };

  /** CIE L*a*b* (D65). */
  function labOf(srgb, vision) {
    const linear = [16, 8, 0].map((shift) => {
      const c = ((srgb >> shift) & 0xff) / 255;
      return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
    });
    const times = (matrix, v) => matrix.map((row) => row.reduce((sum, x, k) => sum + x * v[k], 0));
    const toXyz = [
      [0.4124 / 0.9505, 0.3576 / 0.9505, 0.1805 / 0.9505],
      [0.2126, 0.7152, 0.0722],
      [0.0193 / 1.089, 0.1192 / 1.089, 0.9505 / 1.089],
    ];
    const [x, y, z] = times(toXyz, times(vision, linear)).map((t) =>
      t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116,
    );
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
  }

  test('neighbours look different to all readers', async (context) => {
    const library = await load();
    const mesh = await library.mesh(bumpySphere(40, 60));
    const { data } = await mesh.voronoi(await mesh.sampleSites(400), { metric: 'dgpc' });
    const tones = new RegionColours().assign(data, ids(400));
    for (const [name, vision] of Object.entries(dichromats)) {
      const labs = Array.from(tones, (tone) => labOf(toneColour(tone), vision));
      let least = Infinity;
      for (let i = 0; i < data.arcs.labels.length; i += 2) {
        const [p, q] = [labs[data.arcs.labels[i]], labs[data.arcs.labels[i + 1]]];
        least = Math.min(least, Math.hypot(...p.map((x, k) => x - q[k])));
      }
      context.diagnostic(`least ΔE (CIE 1976) of neighbours, ${name}: ${least.toFixed(1)}`);
      assert.ok(least > 10, `ΔE ${least} for ${name}`);
    }
    library.dispose();
  });

  test('a site keeps its tone when others come, go and change their numbers', () => {
    const colours = new RegionColours();
    const chain = [
      [0, 1],
      [1, 2],
      [2, 3],
    ];
    const [before, after] = [
      [1, 2, 3, 4],
      [2, 3, 4, 9],
    ].map((ids) => colours.assign(adjacency(4, chain), ids));
    assert.deepEqual([...after.subarray(0, 3)], [...before.subarray(1)]);
  });

  test('the tones of sites that are long gone are forgotten', () => {
    const colours = new RegionColours();
    const [, second] = colours.assign(adjacency(2, [[0, 1]]), [1, 2]);
    const alone = () => colours.assign(adjacency(1, []), [second === 0 ? 1 : 2])[0];
    assert.notEqual(alone(), 0);
    for (const first of [1e5, 2e5, 3e5]) {
      const many = Array.from({ length: 15_000 }, (_, i) => first + i);
      colours.assign(adjacency(many.length, []), many);
    }
    assert.equal(alone(), 0, 'as if it were new');
  });
});

suite('a diagram that changes', () => {
  /** The drawings' buffers as the graphics card has them: brought up to date by what is uploaded only. */
  class Card {
    #copies = new Map();

    upload({ object }) {
      for (const buffer of buffersOf(object)) {
        const copy = this.#copies.get(buffer);
        if (!copy) {
          this.#copies.set(buffer, { array: buffer.array.slice(), version: buffer.version });
        } else if (copy.version !== buffer.version) {
          copy.version = buffer.version;
          const ranges = buffer.updateRanges.length
            ? buffer.updateRanges
            : [{ start: 0, count: buffer.array.length }];
          for (const { start, count } of ranges) {
            copy.array.set(buffer.array.subarray(start, start + count), start);
            this.uploaded += count * buffer.array.BYTES_PER_ELEMENT;
          }
          buffer.clearUpdateRanges();
        }
      }
    }

    /** Everything drawn, sorted: triangles, segments and markers with all their numbers. */
    picture({ object }) {
      const of = (attribute) => this.#copies.get(attribute.data ?? attribute).array;
      const list = [];
      object.traverse(({ geometry, visible, type }) => {
        if (!geometry || !visible) return;
        const { attributes, drawRange } = geometry;
        const isLines = 'instanceStart' in attributes;
        const isInstanced = geometry.isInstancedBufferGeometry;
        // That of instances is the same for each: how one of them is drawn.
        const index = isInstanced ? null : geometry.index;
        const names = isLines
          ? ['instanceStart']
          : Object.keys(attributes)
              .filter((name) => !isInstanced || name !== 'position')
              .sort();
        const count = isInstanced
          ? geometry.instanceCount
          : Math.min(drawRange.count, index ? index.count : attributes.position.count);
        const perShape = type === 'Mesh' && !isInstanced ? 3 : 1;
        for (let i = 0; i < count; i += perShape) {
          const corners = Array.from({ length: perShape }, (_, k) =>
            index ? of(index)[i + k] : i + k,
          );
          if (perShape === 3 && corners[0] === corners[1]) continue; // without extent
          const numbers = corners.map((corner) =>
            names.map((name) => {
              const width = attributes[name].data?.stride ?? attributes[name].itemSize;
              return of(attributes[name])
                .subarray(width * corner, width * (corner + 1))
                .join();
            }),
          );
          list.push(`${type} ${geometry.type} ${numbers.join(' | ')}`);
        }
      });
      return list.sort();
    }

    uploaded = 0;
  }

  function buffersOf(object) {
    const buffers = new Set();
    object.traverse(({ geometry }) => {
      if (!geometry) return;
      if (geometry.index) buffers.add(geometry.index);
      for (const attribute of Object.values(geometry.attributes))
        buffers.add(attribute.data ?? attribute);
    });
    return buffers;
  }

  const isAsIfNew = async (tintAt) => {
    const library = await load();
    const mesh = await library.mesh(bumpySphere(40, 60));
    const diagram = await mesh.voronoi(await mesh.sampleSites(60));
    const scene = new SceneMesh(sceneArrays(mesh));
    const colours = new RegionColours();
    const sites = () => [...diagram.sites.face.keys()].map((id) => ({ id }));
    const layers = new Set(['regions', 'bisectors', 'voronoi-points']);
    const wholeSummary = () => DiagramSummary.of(diagram.data);
    const setWhole = (drawing) => {
      const summary = wholeSummary();
      const tones = drawing.assignTones(summary, sites());
      drawing.setDiagram(diagram, { summary, tones });
    };
    const newDrawing = () => {
      const drawing = new ModelDrawing(scene, colours);
      drawing.show(layers);
      if (tintAt) drawing.setTints(scene.positions.filter((_, i) => i % 3 === 0).map(tintAt));
      return drawing;
    };

    const drawing = newDrawing();
    const card = new Card();
    let summary = wholeSummary();
    card.upload(drawing);
    setWhole(drawing); // not uploaded before the first change
    const all = [...buffersOf(drawing.object)].reduce(
      (sum, { array }) => sum + array.byteLength,
      0,
    );

    const places = await mesh.sampleSites(60, { seed: 7 });
    for (let i = 0; i < 21; ++i) {
      const count = diagram.sites.face.length;
      const change = await (i % 3 === 0
        ? i % 9 === 6
          ? diagram.removeSite(count - 1)
          : diagram.insertSite(pointAt(places, i))
        : diagram.moveSite((7 * i) % 60, pointAt(places, i)));
      summary = summary.after(change, diagram.sites.face.length);
      drawing.changeDiagram(change, {
        diagram: {
          get data() {
            return assert.fail('all of the diagram is not needed');
          },
        },
        summary,
        sites: sites(),
      });
      card.uploaded = 0;
      if (i % 4 === 2) continue; // several changes before a drawing
      card.upload(drawing);
      if (i % 3) assert.ok(card.uploaded < 0.5 * all, `${card.uploaded} of ${all} bytes`);
      if (i % 5 > 0 && i !== 6) continue;

      const { siteCount, regionCount, arcCount, segmentCount, voronoiPointCount } = wholeSummary();
      assert.deepEqual(
        [summary.siteCount, summary.regionCount, summary.arcCount, summary.segmentCount],
        [siteCount, regionCount, arcCount, segmentCount],
      );
      assert.equal(summary.voronoiPointCount, voronoiPointCount);
      assertNeighboursDiffer(drawing.assignTones(summary, sites()), pairsOf(summary));

      const anew = newDrawing();
      setWhole(anew);
      for (const each of [drawing, anew]) each.outline.show(change.labels[0]);
      const cardAnew = new Card();
      cardAnew.upload(anew);
      card.upload(drawing);
      assert.deepEqual(card.picture(drawing), cardAnew.picture(anew));
      for (const each of [drawing, anew]) each.outline.show(-1);
    }
    library.dispose();
  };
  test('is drawn and told of as if all of it were new, and little is uploaded', () => isAsIfNew());
  test('also under a painted density', () => isAsIfNew((x) => Math.min(1, Math.max(0, 2 * x))));

  const pairsOf = ({ arcs: { labels } }) =>
    Array.from({ length: labels.length / 2 }, (_, i) => [labels[2 * i], labels[2 * i + 1]]);

  test('one or two steps are a site that moved, came or went at the end, and no two sites meet', () => {
    const sites = new SiteHistory();
    const list = sites.createAll({ face: [1, 2, 3], bary: [1, 0, 0, 1, 0, 0, 1, 0, 0] });
    const moved = list.map((site, i) => (i === 1 ? { ...site, face: 9 } : site));
    const added = [...list, sites.create({ face: 4, bary: [1, 0, 0] })];
    assert.deepEqual(stepsBetween(list, moved), [{ kind: 'move', index: 1, site: moved[1] }]);
    assert.deepEqual(stepsBetween(list, added), [{ kind: 'insert', index: 3, site: added[3] }]);
    assert.deepEqual(stepsBetween(moved, list), [{ kind: 'move', index: 1, site: list[1] }]);
    assert.deepEqual(stepsBetween(added, list), [{ kind: 'remove', index: 3 }]);

    // The last site takes the place of one that goes, and gives it back.
    const rest = without(added, list[1].id);
    assert.deepEqual(rest, [list[0], added[3], list[2]]);
    assert.deepEqual(stepsBetween(added, rest), [
      { kind: 'remove', index: 3 },
      { kind: 'move', index: 1, site: added[3] },
    ]);
    assert.deepEqual(stepsBetween(rest, added), [
      { kind: 'move', index: 1, site: list[1] },
      { kind: 'insert', index: 3, site: added[3] },
    ]);
    assert.deepEqual(without(added, added[3].id), list);
    assert.equal(without(list, added[3].id), list);

    const others = [[...list], [added[3], ...list], [list[1], list[2], list[0]], [list[2]]];
    for (const other of others) assert.equal(stepsBetween(list, other), undefined);
  });

  test('after a step that fails, the diagram is not changed any further', async () => {
    const library = await load();
    const mesh = await library.mesh(octahedron());
    const settings = { metric: 'exact', detail: 0 };
    const middles = (...face) => ({ face, bary: Array(3 * face.length).fill(1 / 3) });
    const [a, b, c, nowhere] = new SiteHistory().createAll(middles(0, 3, 6, 99));
    const moved = { ...a, face: 1 };
    for (const sites of [
      [moved, nowhere],
      [nowhere, moved],
      [nowhere, b],
    ]) {
      const diagram = await mesh.voronoi(middles(0, 3, 6));
      const summary = DiagramSummary.of(diagram.data);
      const shown = { ...settings, sites: [a, b, c], diagram, summary };
      const changeTo = (list) => changeDiagram(shown, { ...settings, sites: list });
      assert.equal(await changeTo([...sites, c]), undefined);
      assert.equal(shown.diagram, undefined);
      await assert.rejects(diagram.locate({ vertex: 0 }), { code: 'disposed' });
      assert.equal(await changeTo([moved, b, c]), undefined);
    }
    library.dispose();
  });

  test('one of another metric or detail is not changed', async () => {
    const library = await load();
    const mesh = await library.mesh(octahedron());
    const settings = { metric: 'exact', detail: 0 };
    const middle = { face: [0], bary: [1, 1, 1].map((x) => x / 3) };
    const sites = new SiteHistory().createAll(middle);
    const diagram = await mesh.voronoi(middle);
    const summary = DiagramSummary.of(diagram.data);
    const shown = { ...settings, sites, diagram, summary };
    const moved = [{ ...sites[0], face: 1 }];
    for (const other of [{ metric: 'dgpc' }, { detail: 1 }])
      assert.equal(await changeDiagram(shown, { ...settings, ...other, sites: moved }), undefined);
    assert.equal(shown.diagram, diagram);
    assert.equal((await changeDiagram(shown, { ...settings, sites: moved })).length, 1);
    library.dispose();
  });
});

suite('model frame', () => {
  test('any size and any place become the unit sphere', () => {
    const { positions, indices } = octahedron();
    for (const [size, shift] of [
      [1, 0],
      [1e-9, 0],
      [1e9, 0],
      [1e-3, 6e6],
    ]) {
      const placed = positions.map((x) => size * x + shift);
      const scene = ModelFrame.around(placed, indices).toScene(placed);
      scene.forEach((x, i) =>
        assert.ok(Math.abs(x - positions[i]) < 1e-5, `${x} for ${positions[i]}`),
      );
    }
  });

  test('corners that are no numbers, and vertices that no triangle uses, do not count', () => {
    const positions = [0, 0, 0, 2, 0, 0, 0, 2, 0, NaN, 0, 0, 1e9, 0, 0];
    const scene = ModelFrame.around(positions, [0, 1, 2, 0, 1, 3]).toScene(positions.slice(0, 9));
    assert.ok(scene.every((x) => Math.abs(x) <= 1));
  });
});

suite('corner normals', () => {
  const normalsOf = ({ positions, indices }) =>
    cornerNormals(Float32Array.from(positions), Int32Array.from(indices));

  test('a crease keeps the normals of its faces', () => {
    const shape = octahedron();
    const third = 1 / Math.sqrt(3);
    const [x, y, z] = normalsOf(shape);
    for (const c of [x, y, z]) assert.ok(Math.abs(c - third) < 1e-6);
  });

  test('a smooth surface has one normal at a vertex, also where it is stored twice', () => {
    const ridge = [0, 0, 0, 0, 0, 1, 1, 0.1, 0, -1, 0.1, 0, 0, 0, 0, 0, 0, 1];
    const normals = normalsOf({ positions: ridge, indices: [0, 1, 2, 5, 4, 3] });
    assert.deepEqual([...normals.subarray(0, 3)], [...normals.subarray(12, 15)]);
    assert.ok(Math.abs(normals[0]) < 1e-6, 'between those of the two faces');
  });
});

test('a face with a corner that is no number does not shade those around it', () => {
  const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, NaN, -1, 0.1);
  const indices = Int32Array.of(0, 1, 2, 1, 0, 3);
  const { normals } = sceneArrays({ positions, indices });
  assert.deepEqual([...normals.subarray(0, 9)], [0, 0, 1, 0, 0, 1, 0, 0, 1]);
});

suite('energy of hexagons', () => {
  const square = ({ positions, indices }) => ({
    positions: Float64Array.from(positions),
    indices: Int32Array.from(indices),
  });

  test('is that of a hexagon of the same area, for each site', () => {
    // ∫ d² over a regular hexagon of side 1 is 5√3/8, its area 3√3/2.
    const area = (3 * Math.sqrt(3)) / 2;
    const energy = hexagonEnergy({ siteCount: 4, regionArea: new Float64Array(4).fill(area) });
    assert.ok(Math.abs(energy - (4 * 5 * Math.sqrt(3)) / 8) < 1e-12);
  });

  test('a density c has √c times the area as its weight', () => {
    const mesh = square(grid(7));
    const uniform = (c) => rootDensityIntegral(mesh, new Float64Array(64).fill(c));
    assert.ok(Math.abs(uniform(1) - 1) < 1e-12);
    assert.ok(Math.abs(uniform(9) - 3) < 1e-12);
  });
});

suite('density paint', () => {
  const sceneMesh = ({ positions, indices }) =>
    new SceneMesh(
      sceneArrays({
        positions: Float64Array.from(positions),
        indices: Int32Array.from(indices),
      }),
    );
  const centreOf = ({ positions, indices }, face) => ({
    face,
    place: Object.fromEntries(
      ['x', 'y', 'z'].map((name, axis) => [
        name,
        [0, 1, 2].reduce((sum, k) => sum + positions[3 * indices[3 * face + k] + axis] / 3, 0),
      ]),
    ),
  });

  test('a dab reaches what is connected and near, and repeated it comes to the density', () => {
    const mesh = sceneMesh(apart(grid(10), grid(10)));
    const paint = new DensityPaint(mesh);
    assert.equal(paint.density, undefined);
    const hit = centreOf(mesh, 0);
    for (let i = 0; i < 50; ++i) paint.dab(hit, { radius: 1e9, density: 100 });
    const { density } = paint;
    assert.ok(density.subarray(0, 121).every((each) => Math.abs(each - 100) < 1e-3));
    assert.ok(
      density.subarray(121).every((each) => each === 1),
      'the other part is not connected',
    );

    for (let i = 0; i < 50; ++i) paint.dab(hit, { radius: 1e9, density: 1 });
    assert.equal(paint.density, undefined, 'painted over');
  });

  test('near is what is within the radius, over seams too', () => {
    // Every triangle has vertices of its own.
    const mesh = sceneMesh(torn(grid(10)));
    const paint = new DensityPaint(mesh);
    const hit = centreOf(mesh, 90);
    const radius = 0.4;
    paint.dab(hit, { radius, density: greatestDensity });
    const { x, y, z } = hit.place;
    let painted = 0;
    paint.density.forEach((density, v) => {
      const [px, py, pz] = mesh.positions.subarray(3 * v, 3 * v + 3);
      const isNear = Math.hypot(px - x, py - y, pz - z) < radius;
      assert.equal(density > 1, isNear);
      if (isNear) ++painted;
    });
    assert.ok(painted > 20);
  });

  test('a density that is set is kept between a thousandth and a thousand', () => {
    const paint = new DensityPaint(sceneMesh(octahedron()));
    paint.density = [1, 10, 1e9, 0, 1, 0.1];
    const expected = [1, 10, 1000, 0.001, 1, 0.1];
    paint.density.forEach((density, v) => {
      assert.ok(Math.abs(density / expected[v] - 1) < 1e-5);
    });
  });
});

suite('framing', () => {
  test('a model that is deep along the view stands in its middle, and just fits', () => {
    const right = new Vector3(1, 0, 0.5).normalize();
    const back = new Vector3(-0.4, 0.3, 0.8).normalize();
    const up = back.clone().cross(right).normalize();
    right.copy(up).cross(back);
    const beam = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [x, y, -9, x, y, 9]));
    const points = Float32Array.from([...beam, NaN, 0, 0], (x) => x / 9.2);
    for (const [h, v] of [
      [0.3, 0.2],
      [1.5, 0.2],
      [0.1, 0.4],
    ]) {
      const { target, distance } = framingOf(points, { right, up, back }, h, v);
      const eye = target.clone().addScaledVector(back, distance);
      const seen = beam.length / 3;
      const [x, y] = [right, up].map((axis) =>
        Array.from({ length: seen }, (_, i) => {
          const point = new Vector3().fromArray(points, 3 * i).sub(eye);
          return point.dot(axis) / -point.dot(back);
        }),
      );
      const range = (values) => [Math.min(...values), Math.max(...values)];
      const [[left, rightmost], [bottom, top]] = [range(x), range(y)];
      const fills = Math.max((rightmost - left) / (2 * h), (top - bottom) / (2 * v));
      assert.ok(Math.abs(fills - 1) < 1e-6, `${fills} of the view`);
      assert.ok(Math.abs(left + rightmost) < 0.1 * h, `from ${left} to ${rightmost} of ±${h}`);
      assert.ok(Math.abs(bottom + top) < 0.1 * v, `from ${bottom} to ${top} of ±${v}`);
    }
    const none = framingOf(new Float32Array(3), { right, up, back }, 0.3, 0.2);
    assert.deepEqual(none, { target: new Vector3(), distance: 3 });
  });
});

suite('site history', () => {
  const history = () => {
    const sites = new SiteHistory();
    sites.reset(sites.createAll({ face: [1, 2], bary: [1, 0, 0, 0, 1, 0] }));
    return sites;
  };

  test('a step that is revised is one step', () => {
    const sites = history();
    const first = sites.present;
    sites.record([first[0]]);
    sites.revise([first[1]]);
    sites.revise([]);
    sites.undo();
    assert.equal(sites.present, first);
    assert.equal(sites.canUndo, false);
    sites.redo();
    assert.deepEqual(sites.present, []);
  });

  test('a new step forgets what was undone', () => {
    const sites = history();
    sites.record([]);
    sites.undo();
    sites.record([sites.create({ face: 3, bary: [0, 0, 1] })]);
    assert.equal(sites.canRedo, false);
    assert.equal(new Set([...sites.present, ...history().present]).size, 3);
  });

  test('a move that is cancelled leaves nothing behind, nor takes away what was undone', () => {
    const sites = history();
    const lists = [sites.present, [], [sites.present[0]]];
    sites.record(lists[1]);
    sites.record(lists[2]);
    sites.undo();
    sites.undo();
    const [{ id }] = lists[0];
    for (const face of [3, 5]) assert.equal(sites.move(id, { face, bary: [1, 0, 0] }, false), true);
    assert.deepEqual(
      sites.present.map((site) => site.id),
      lists[0].map((site) => site.id),
    );
    assert.equal(sites.present[0].face, 5);
    assert.equal(sites.cancelMove(), true);
    assert.equal(sites.isMoving, false);
    assert.equal(sites.cancelMove(), false);
    assert.equal(sites.present, lists[0]);
    assert.equal(sites.canUndo, false);
    for (const list of lists.slice(1)) {
      sites.redo();
      assert.equal(sites.present, list);
    }
    assert.equal(sites.canRedo, false);
  });

  test('another step during a move is not taken back with that', () => {
    for (const step of ['record', 'recordTints']) {
      const sites = history();
      const [{ id }] = sites.present;
      sites.move(id, { face: 3, bary: [1, 0, 0] }, false);
      sites[step](step === 'record' ? sites.present.slice(0, 1) : Float32Array.of(0, 1));
      const { present, tints } = sites;
      assert.equal(sites.cancelMove(), false);
      assert.deepEqual([sites.present, sites.tints], [present, tints]);
      sites.move(id, { face: 5, bary: [1, 0, 0] }, false);
      assert.equal(sites.cancelMove(), true);
      assert.deepEqual([sites.present, sites.tints], [present, tints]);
    }
  });

  test('a hundred steps can be undone: what is before them is forgotten', () => {
    const sites = history();
    for (let i = 0; i < 250; ++i) sites.recordTints(Float32Array.of(0, i));
    let undone = 0;
    for (; sites.canUndo; ++undone) sites.undo();
    assert.equal(undone, 100);
    assert.deepEqual([...sites.tints], [0, 149]);
  });

  test('the density is part of it', () => {
    const sites = history();
    const first = sites.present;
    const painted = Float32Array.of(0, 1);
    sites.recordTints(painted);
    sites.record([]);
    assert.equal(sites.tints, painted);
    sites.revise([first[0]]);
    sites.undo();
    assert.equal(sites.present, first);
    assert.equal(sites.tints, painted);
    sites.undo();
    assert.equal(sites.tints, undefined);
    assert.equal(sites.canUndo, false);
    sites.redo();
    sites.redo();
    assert.deepEqual([sites.present, sites.tints], [[first[0]], painted]);
    sites.returnTo(first);
    assert.equal(sites.tints, painted, 'no further than needed');
  });

  test('it returns to a list by undoing or redoing', () => {
    const sites = history();
    const lists = [sites.present, [], [sites.present[0]]];
    sites.record(lists[1]);
    sites.record(lists[2]);
    for (const list of [lists[0], lists[2], lists[1]]) {
      sites.returnTo(list);
      assert.equal(sites.present, list);
    }
    assert.ok(sites.canUndo && sites.canRedo);
  });

  test('it returns to a list of which a step was revised, and keeps what is before', () => {
    const sites = history();
    const lists = [sites.present, []];
    sites.record(lists[1]);
    const [{ id }] = lists[0];
    sites.undo();
    sites.recordTints(Float32Array.of(0, 1));
    sites.move(id, { face: 3, bary: [1, 0, 0] }, false);
    const shown = sites.present;
    sites.move(id, { face: 5, bary: [1, 0, 0] }, false);
    sites.returnTo(shown);
    assert.equal(sites.present, shown);
    sites.undo();
    assert.equal(sites.present, lists[0]);
    sites.undo();
    assert.equal(sites.tints, undefined);
  });
});

suite('latest task', () => {
  /** Jobs that are done when the test says so. */
  function controlled() {
    const log = [];
    const finish = [];
    const task = new LatestTask((job, signal) => {
      log.push(`start ${job}`);
      return new Promise((resolve) => {
        finish.push(() => {
          log.push(`end ${job}`);
          resolve();
        });
        signal.addEventListener('abort', () => {
          log.push(`abort ${job}`);
          resolve();
        });
      });
    });
    return { task, log, finish };
  }
  const turn = () => new Promise((resolve) => setImmediate(resolve));

  test('the patient wait for the one that runs, and only the latest of them follows', async () => {
    const { task, log, finish } = controlled();
    for (const job of ['a', 'b', 'c']) task.request(job, { patient: true });
    finish[0]();
    await turn();
    assert.deepEqual(log, ['start a', 'end a', 'start c']);
  });

  test('others end it', async () => {
    const { task, log } = controlled();
    task.request('a');
    task.request('b', { patient: true });
    task.hurry();
    await turn();
    task.request('c');
    await turn();
    assert.deepEqual(log, ['start a', 'abort a', 'start b', 'abort b', 'start c']);
    task.hurry();
    task.request('d', { patient: true });
    task.cancel();
    await turn();
    assert.equal(log.at(-1), 'abort c', 'what waits is dropped, too');
  });
});

test('no area is told while the diagram is of other sites than there are', () => {
  const element = Object.assign(new EventTarget(), { regionAreas: Float64Array.of(1, 2, 3) });
  const told = [];
  setUpAnnouncements(element, (sentence) => told.push(sentence));
  const emit = (type, detail) => element.dispatchEvent(new CustomEvent(type, { detail }));
  emit('sites-change', { selected: 1, count: 3 });
  emit('sites-change', { selected: 1, count: 2 });
  emit('diagram');
  element.regionAreas = Float64Array.of(1, 4);
  emit('diagram');
  assert.deepEqual(told, ['Site 1 selected, of 3, region of area 2', 'Region of area 4']);
});

test('a key gives a command of its own, or none', () => {
  assert.equal(commandOf({ key: 'F' }), 'refit');
  assert.equal(commandOf({ key: 'ArrowUp', shiftKey: true }), 'move-up');
  for (const key of ['x', 'constructor', 'Shift']) assert.equal(commandOf({ key }), undefined);
});

test('the element can be imported where there is no DOM', async () => {
  const { GeodesicVoronoiElement } = await import('../../dist/viewer/element.js');
  assert.equal(typeof GeodesicVoronoiElement, 'function');
});
