// SPDX-License-Identifier: BSD-3-Clause
// The project file of a machine on mounts, from the numbers of a form. The program computes everything else from it.

export const QUESTIONS = {
  mass: {label: 'Mass', unit: 'kg', value: 400},
  length: {label: 'Length, along the shaft', unit: 'mm', value: 1200},
  width: {label: 'Width', unit: 'mm', value: 600},
  height: {label: 'Height', unit: 'mm', value: 500},
  centre: {label: 'Centre of mass above the mounts', unit: 'mm', value: 250},
  pairs: {label: 'Pairs of mounts', unit: '', value: 2},
  vertical: {label: 'Vertical stiffness of a mount', unit: 'N/mm', value: 300},
  lateral: {label: 'Horizontal stiffness of a mount', unit: 'N/mm', value: 150},
  speed: {label: 'Speed', unit: 'rpm', value: 1500},
} as const;
export type Question = keyof typeof QUESTIONS;
export type Numbers = Record<Question, number>;
/// Not asked if the mount is of a catalogue.
export const OF_A_MOUNT: readonly Question[] = ['vertical', 'lateral'];

/// What is wrong with the numbers; empty: nothing. @param mount  of the generic catalogue; empty: by its stiffness
export function wrongNumber(numbers: Numbers, mount = ''): string {
  const asked = (Object.keys(QUESTIONS) as Question[]).filter(q => !mount || !OF_A_MOUNT.includes(q)), wrong = asked.find(q => !(numbers[q] > 0 && Number.isFinite(numbers[q])));
  if (wrong) return `${QUESTIONS[wrong].label}: a number above 0 is expected.`;
  return Number.isInteger(numbers.pairs) && numbers.pairs <= 8 ? '' : 'Pairs of mounts: 1 to 8.';
}

/// @param mount  of the generic catalogue; empty: by its stiffness
export function newMachine(title: string, n: Numbers, mount = ''): string {
  const round = (value: number) => String(Number(value.toPrecision(5)));
  const rows = Array.from({length: n.pairs}, (_, i) => {
    const x = n.pairs === 1 ? 0 : 0.8 * n.length * (0.5 - i / (n.pairs - 1)), y = 0.4 * n.width;
    return [['left', y], ['right', -y]].map(([side, at]) =>
      `  {name = "${i + 1} ${side}", type = "mount", on = "machine", at = ["${round(x)} mm", "${round(at as number)} mm", 0]},`).join('\n');
  });
  return `# A machine on mounts, from the form of trivet serve. Replace the numbers by better ones as you know them.
trivet = 1
title = ${JSON.stringify(title || 'New machine')}
gravity = [0, 0, -9.80665]

[bodies.machine]                 # pole in the plane of the mounts, x along the shaft, z up
mass = "${round(n.mass)} kg"
# A homogeneous box. With measured data: center_of_mass and inertia in place of solids.
solids = [{box = ["${round(n.length)} mm", "${round(n.width)} mm", "${round(n.height)} mm"], at = [0, 0, "${round(n.centre)} mm"]}]

${mount ? ofCatalogue(mount) : byStiffness(round(n.lateral), round(n.vertical))}
[tables.elements]
rows = [
${rows.join('\n')}
]

[excitations.unbalance]          # residual unbalance of a rotor of a third of the mass, balanced to G 6.3
type = "unbalance"
on = "machine"
at = [0, 0, "${round(n.centre)} mm"]
axis = "x"
grade = 6.3
rotor_mass = "${round(n.mass / 3)} kg"
service_speed = "${round(n.speed)} rpm"

[analyses.response]
band = ["1 Hz", "${round(1.5 * n.speed / 60)} Hz"]
of = ["machine", "ground"]

[requirements]                   # at ${round(n.speed)} rpm ± 5 %
band = ["${round(0.95 * n.speed / 60)} Hz", "${round(1.05 * n.speed / 60)} Hz"]
limits = {"machine.z" = "4.5 mm/s rms"}
natural_frequencies = {avoid = [["${round(0.8 * n.speed / 60)} Hz", "${round(1.2 * n.speed / 60)} Hz"]]}
${mount ? `mount_load = "catalogue"         # static load of each mount within the range of the catalogue
` : ''}`;
}
const byStiffness = (lateral: string, vertical: string) => `[element_types.mount]            # properties of all mounts; a mount of a catalogue: type = "catalogue:NAME"
type = "bushing"
translation = ["${lateral} N/mm", "${lateral} N/mm", "${vertical} N/mm"]
rotation = [0, 0, 0]
damping = {loss_factor = 0.1}
`;
const ofCatalogue = (mount: string) => `[element_types.mount]            # all mounts, of the generic catalogue: no maker's data. Your own: catalogue = "maker.toml"
type = ${JSON.stringify(`catalogue:${mount}`)}
`;
