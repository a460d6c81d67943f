// SPDX-License-Identifier: MIT
//
// Drawings that are made only while they are shown: of a diagram the parts, the distances and the
// dual, of a model its file's own material and its wireframe.

import type { Diagram, Violation } from 'geodesic-voronoi';
import type { Attributes } from '../attributes/attribute_values.js';
import { meshEdges } from '../buffers/mesh_edges.js';
import { Derived } from './derived.js';
import { distanceScale } from '../drawing/distance_scale.js';
import type { DrawnDistances } from '../drawing/distance_surface.js';
import type { Emit } from '../events.js';
import { type ExplodedParts, widestSpread } from '../drawing/exploded_parts.js';
import type { Legend } from './legend.js';
import { boundarySides, chainEnds } from '../drawing/lines.js';
import type { OriginalMaterial } from '../drawing/original_material.js';
import { sentence } from '../session/failure.js';
import { nextFrame } from '../stage/next_frame.js';
import type { OpenModel } from '../model/open_model.js';
import type { Session } from '../session/session.js';
import type { ShownDiagram } from '../session/shown_diagram.js';
import type { Stage } from '../stage/stage.js';

/** The scene that they are drawn in. */
export interface DrawingPlace {
  readonly attributes: Attributes;
  readonly stage: Stage;
  readonly session: Session;
  readonly model: OpenModel | undefined;
  readonly legend: Legend;
}

/** The exploded view. */
interface Parts {
  regions: number;
  parts: ExplodedParts;
}

/** The dual's sides, and whether it has the topology of the surface. */
interface Dual {
  /** Both ends of every piece of the sides. */
  ends: Float32Array;
  polygons: number;
  violations: readonly Violation[];
}

/** In milliseconds, how long a site that is dragged rests before the drawings follow. */
const dragRest = 150;

function workerStopped(): Error {
  return new Error('the worker that prepares drawings has stopped; open the model once more');
}

export class DerivedDrawings {
  readonly #place: DrawingPlace;
  readonly #emit: Emit;
  readonly #dual = this.#ofDiagram<Dual>(
    'The dual cannot be made',
    (diagram, signal) => this.#makeDual(diagram, signal),
    (dual) => this.#showDual(dual),
  );
  readonly #parts = this.#ofDiagram<Parts>(
    'The exploded view cannot be drawn',
    (diagram, signal) => this.#makeParts(diagram, signal),
    (parts) => this.#showParts(parts),
    ({ parts }) => parts.dispose(),
  );
  readonly #distances = this.#ofDiagram<DrawnDistances>(
    'The distances cannot be drawn',
    (diagram, signal) => this.#makeDistances(diagram, signal),
    (distances) => this.#showDistances(distances),
  );
  readonly #original = new Derived<OpenModel, OriginalMaterial>({
    compute: (model, signal) => this.#readOriginal(model, signal),
    adopt: (original, error) => this.#showOriginal(original, error as Error | undefined),
    discard: (original) => original.dispose(),
  });
  /** The model whose edges have been asked for: they stay with it. */
  #withEdges: OpenModel | undefined;
  #resting: ReturnType<typeof setTimeout> | undefined;

  constructor(place: DrawingPlace, emit: Emit) {
    this.#place = place;
    this.#emit = emit;
  }

  /** A drawing of the diagram that is shown; `failing` says what cannot be done if that fails. */
  #ofDiagram<Result>(
    failing: string,
    compute: (diagram: Diagram, signal: AbortSignal) => Promise<Result | undefined>,
    show: (result: Result | undefined) => void,
    discard?: (result: Result) => void,
  ): Derived<ShownDiagram, Result> {
    return new Derived({
      compute: async ({ diagram }, signal) => diagram && compute(diagram, signal),
      adopt: (result, error) => {
        if (error) {
          const { message } = sentence(failing, error);
          this.#emit('error', { type: 'computefailure', message, cause: error });
        }
        show(result);
      },
      discard,
    });
  }

  /**
   * To be called whenever the session has another status, or the attributes ask for other drawings.
   * A diagram answers one call after the other, and these take as long as a whole diagram: they wait
   * until nothing else is under way. Iterations are shown without them.
   */
  update(): void {
    const { session, attributes, model } = this.#place;
    void this.#original.update(attributes.layers.includes('original') ? model : undefined);
    void this.#findEdges();
    clearTimeout(this.#resting);
    if (session.status === 'iterating') this.#show(undefined);
    else if (session.status !== 'ready') this.#stop();
    else if (!session.isMoving) this.#show(session.shown);
    else this.#resting = setTimeout(() => this.#show(session.shown), dragRest);
  }

  /** To be called when the model is replaced: nothing of the diagram before stays. */
  clear(): void {
    clearTimeout(this.#resting);
    this.#show(undefined);
  }

  dispose(): void {
    clearTimeout(this.#resting);
    this.#stop();
    this.#original.stop();
  }

  #stop(): void {
    for (const each of [this.#dual, this.#distances, this.#parts]) each.stop();
  }

  /** Shows what the attributes ask for of this diagram; nothing without a diagram. */
  #show(shown: ShownDiagram | undefined): void {
    const { layers, exploded } = this.#place.attributes;
    void this.#dual.update(layers.includes('dual') ? shown : undefined);
    void this.#distances.update(layers.includes('distances') ? shown : undefined);
    void this.#parts.update(exploded > 0 ? shown : undefined);
  }

  /** Moves the regions of the exploded view as far as the attributes ask for. */
  spread(): void {
    const { attributes, model, stage } = this.#place;
    model?.drawing.spread(attributes.exploded);
    stage.camera.reach = 1 + widestSpread * attributes.exploded;
    stage.invalidate();
  }

  async #makeParts(diagram: Diagram, signal: AbortSignal): Promise<Parts | undefined> {
    const { points, triangles, regions } = await diagram.partition({ signal });
    const { model, stage } = this.#place;
    if (!model) return undefined;
    const { builder, drawing } = model;
    const drawn = {
      points: { position: points.position },
      triangles,
      regions: { centroid: regions.centroid },
    };
    const made = await builder.ask('parts', drawn, drawing.tones.slice());
    signal.throwIfAborted();
    if (!made) throw workerStopped();
    const parts = drawing.prepareParts(made);
    for (let isFirst = true; !signal.aborted && parts.uploadMore(); isFirst = false) {
      if (isFirst) await stage.compile(parts.object);
      stage.invalidate();
      await nextFrame();
    }
    return { regions: regions.area.length, parts };
  }

  #showParts(shown: Parts | undefined): void {
    this.#place.model?.drawing.setExploded(shown?.parts);
    this.spread();
    const detail = shown && { regions: shown.regions, triangles: shown.parts.triangleCount };
    this.#emit('exploded', detail ?? null);
  }

  async #makeDistances(diagram: Diagram, signal: AbortSignal): Promise<DrawnDistances | undefined> {
    const { model } = this.#place;
    if (!model) return undefined;
    const { mesh } = model.drawing;
    const { points, cells, faceLabel } = await diagram.fetchData({ signal });
    const corners = await model.builder.ask('corners', faceLabel);
    signal.throwIfAborted();
    if (!corners) throw workerStopped();
    const atPoints = await diagram.locate(points, { signal });
    const atCorners = await diagram.locate(corners.points, { signal });
    const atVertices = new Float64Array(mesh.positions.length / 3).fill(Infinity);
    corners.vertex.forEach((v, i) => {
      atVertices[v] = atCorners.distance[i];
    });
    let longest = 0;
    for (const { distance } of [atPoints, atCorners]) {
      for (const each of distance) if (each > longest && each < Infinity) longest = each;
    }
    const triangles = await model.builder.ask('distances', {
      cells: { cells, points: { position: points.position } },
      faceLabel,
      atPoints: atPoints.distance,
      atVertices,
    });
    signal.throwIfAborted();
    if (!triangles) throw workerStopped();
    return { triangles, scale: distanceScale(longest) };
  }

  #showDistances(distances: DrawnDistances | undefined): void {
    const { model, stage, legend } = this.#place;
    model?.drawing.setDistances(distances);
    legend.showDistances(distances?.scale);
    stage.invalidate();
    this.#emit('distances', distances ? { longest: distances.scale.longest } : null);
  }

  async #makeDual(diagram: Diagram, signal: AbortSignal): Promise<Dual | undefined> {
    const paths = await diagram.dualPaths({ signal });
    const dual = await diagram.dual({ signal });
    const violations = await diagram.violations({ signal });
    const { model } = this.#place;
    if (!model) return undefined;
    const { drawing, picker } = model;
    await picker.prepared;
    const siteCount = diagram.sites.face.filter((face) => face >= 0).length;
    const inside = chainEnds(drawing.mesh, paths);
    const beside = await boundarySides(drawing.mesh, dual, siteCount, (place) =>
      picker.nearest(place),
    );
    const ends = new Float32Array(inside.length + beside.length);
    ends.set(inside);
    ends.set(beside, inside.length);
    return { ends, polygons: dual.faces.offset.length - 1, violations };
  }

  #showDual(dual: Dual | undefined): void {
    this.#place.model?.drawing.setDual(dual?.ends ?? new Float32Array());
    this.#place.stage.invalidate();
    this.#emit('dual', dual ? { polygons: dual.polygons, violations: dual.violations } : null);
  }

  async #readOriginal(
    { files, drawing, builder }: OpenModel,
    signal: AbortSignal,
  ): Promise<OriginalMaterial | undefined> {
    const { originalMaterial } = await import('../drawing/original_material.js');
    const material = await originalMaterial(files, drawing.mesh.frame, builder, signal);
    if (material) await this.#place.stage.compile(material.object);
    return material;
  }

  #showOriginal(material: OriginalMaterial | undefined, error: Error | undefined): void {
    const { attributes, model, stage } = this.#place;
    model?.drawing.setOriginal(material);
    stage.invalidate();
    const { textures = 0 } = material ?? {};
    const detail = { isFound: material !== undefined, textures, problem: error?.message };
    this.#emit('original', attributes.layers.includes('original') ? detail : null);
  }

  /** Finds the edges of the model's triangles if the attributes ask for them. */
  async #findEdges(): Promise<void> {
    const { attributes, model, stage } = this.#place;
    if (!model || model === this.#withEdges || !attributes.layers.includes('wireframe')) return;
    this.#withEdges = model;
    const edges = await model.builder.ask('edges');
    if (model !== this.#place.model) return;
    model.drawing.setEdges(edges ?? meshEdges(model.drawing.mesh.indices));
    stage.invalidate();
  }
}
