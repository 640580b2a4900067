// SPDX-License-Identifier: BSD-3-Clause
// The scenes that a report stores (src/trivet/report/page/machine_json.h): each surface once, though cases that differ in a mass
// alone have scenes of their own.
import type {Scene, SceneBody} from '../results.ts';

type Surface = SceneBody['solids'][number];
type StoredBody = Omit<SceneBody, 'solids'> & {solids: readonly number[]};  // their places in the list of surfaces
export interface StoredScenes {
  surfaces: readonly Surface[];
  scenes: readonly (Omit<Scene, 'bodies'> & {bodies: readonly StoredBody[]})[];
}

/// Scenes as `trivet scene` states them.
export const scenesOf = ({scenes, surfaces}: StoredScenes): Scene[] => scenes.map(scene => ({
  ...scene, bodies: scene.bodies.map(body => ({...body, solids: body.solids.map(place => surfaces[place]!)}))}));
