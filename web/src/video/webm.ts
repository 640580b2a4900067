// SPDX-License-Identifier: BSD-3-Clause
// A WebM file (Matroska, RFC 9559) of one video track whose frames are equally spaced.

export interface EncodedFrame {
  data: Uint8Array;
  key: boolean;
}
export interface Video {
  codec: 'V_VP8' | 'V_VP9';
  width: number;
  height: number;
  frameDuration: number;  // [ms], a whole number
  frames: readonly EncodedFrame[];
  colours: VideoColorSpaceInit;  // how the encoder has written them: players of other colours would change the picture
}
/// Codes of ITU-T H.273.
const MATRICES: Record<string, number> = {rgb: 0, bt709: 1, bt470bg: 5, smpte170m: 6}, TRANSFERS: Record<string, number> = {bt709: 1, smpte170m: 6, 'iec61966-2-1': 13},
      PRIMARIES: Record<string, number> = {bt709: 1, bt470bg: 5, smpte170m: 6}, UNSPECIFIED = 2;

/// The bytes of the file.
export function webm(video: Video): Uint8Array {
  const {frames, frameDuration} = video;
  const head = element(0x1a45dfa3, element(0x4286, whole(1)), element(0x42f7, whole(1)), element(0x42f2, whole(4)), element(0x42f3, whole(8)),
                       element(0x4282, text('webm')), element(0x4287, whole(4)), element(0x4285, whole(2)));
  const info = element(0x1549a966, element(0x2ad7b1, whole(1e6)),  // times are in ms
                       element(0x4489, real(frames.length * frameDuration)), element(0x4d80, text('Trivet')), element(0x5741, text('Trivet')));
  return joined([head, element(0x18538067, info, tracks(video), ...clusters(video))]);
}

const tracks = ({codec, width, height, frameDuration, colours}: Video) =>
  element(0x1654ae6b, element(0xae, element(0xd7, whole(1)), element(0x73c5, whole(1)), element(0x83, whole(1)), element(0x9c, whole(0)), element(0x86, text(codec)),
                              element(0x23e383, whole(frameDuration * 1e6)), element(0xe0, element(0xb0, whole(width)), element(0xba, whole(height)), colour(colours))));
const colour = ({matrix, transfer, primaries, fullRange}: VideoColorSpaceInit) =>
  element(0x55b0, element(0x55b1, whole(MATRICES[matrix ?? ''] ?? UNSPECIFIED)), element(0x55b9, whole(fullRange ? 2 : 1)),
                  element(0x55ba, whole(TRANSFERS[transfer ?? ''] ?? UNSPECIFIED)), element(0x55bb, whole(PRIMARIES[primaries ?? ''] ?? UNSPECIFIED)));

/// Groups of frames: a frame has its time in 16 bits from the beginning of its cluster, and one begins with each key frame.
function clusters({frames, frameDuration}: Video): Uint8Array[] {
  const found: {begin: number; blocks: Uint8Array[]}[] = [];
  frames.forEach(({data, key}, i) => {
    const time = i * frameDuration;
    if (key || time - found.at(-1)!.begin > 0x7fff) found.push({begin: time, blocks: []});
    const {begin, blocks} = found.at(-1)!, after = time - begin;
    blocks.push(element(0xa3, Uint8Array.of(0x81, after >> 8, after & 0xff, key ? 0x80 : 0), data));
  });
  return found.map(({begin, blocks}) => element(0x1f43b675, element(0xe7, whole(begin)), ...blocks));
}

/// An element of EBML: its identifier, the length of its content in eight bytes, its content.
function element(id: number, ...content: Uint8Array[]): Uint8Array {
  const size = whole(content.reduce((sum, c) => sum + c.length, 0)), length = new Uint8Array(8);
  length[0] = 0x01;
  length.set(size, 8 - size.length);
  return joined([whole(id), length, ...content]);
}
/// A whole number ≥ 0 in as few bytes as it needs, most significant first.
function whole(value: number): Uint8Array {
  const bytes: number[] = [];
  do {
    bytes.unshift(value % 256);
    value = Math.floor(value / 256);
  } while (value > 0);
  return Uint8Array.from(bytes);
}
function real(value: number): Uint8Array {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value);
  return bytes;
}
const text = (value: string) => new TextEncoder().encode(value);
function joined(parts: readonly Uint8Array[]): Uint8Array {
  const all = new Uint8Array(parts.reduce((sum, p) => sum + p.length, 0));
  let place = 0;
  for (const part of parts) {
    all.set(part, place);
    place += part.length;
  }
  return all;
}
