// SPDX-License-Identifier: BSD-3-Clause
// Colours of the drawing, dark and light. They differ in lightness, too, so that they can be told apart without hue.

export interface Colours {
  background: number;
  body: number;
  edge: number;
  mount: number;
  metal: number;
  selected: number;
  force: number;
  rest: number;
  grid: number;
  trace: number;
  text: string;
}
export const LIGHT: Colours = {background: 0xf4f6f8, body: 0x9db4c8, edge: 0x38505f, mount: 0x3b4a54, metal: 0x8b959c, selected: 0xe07b00,
                               force: 0xc4391d, rest: 0x5d7483, grid: 0xd3dae0, trace: 0x00659c, text: '#24323b'};
export const DARK: Colours = {background: 0x14191d, body: 0x5f7d96, edge: 0xb9cfdf, mount: 0x9aa7b0, metal: 0x6a757d, selected: 0xffb347,
                              force: 0xff8a66, rest: 0x8fa5b3, grid: 0x2b343b, trace: 0x7cc7f2, text: '#dbe5ec'};
