// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {framesOf} from '../src/video/period_video.ts';
import {webm, type Video} from '../src/video/webm.ts';

interface Read {
  id: number;
  data: Uint8Array;
  children: Read[];
}
const MASTERS = new Set([0x1a45dfa3, 0x18538067, 0x1549a966, 0x1654ae6b, 0xae, 0xe0, 0x55b0, 0x1f43b675]);
/// Elements by the rules of EBML (RFC 8794): the leading zeros of the first byte state how many bytes follow.
function elements(bytes: Uint8Array): Read[] {
  const found: Read[] = [];
  for (let at = 0; at < bytes.length;) {
    const number = (keepMarker: boolean) => {
      const width = Math.clz32(bytes[at]!) - 23;
      let value = keepMarker ? bytes[at]! : bytes[at]! & (0xff >> width);
      for (let i = 1; i < width; i++) value = value * 256 + bytes[at + i]!;
      at += width;
      return value;
    };
    const id = number(true), size = number(false), data = bytes.subarray(at, at + size);
    assert.equal(data.length, size, 'an element ends within its file');
    found.push({id, data, children: MASTERS.has(id) ? elements(data) : []});
    at += size;
  }
  return found;
}
const find = (list: Read[], ...path: number[]): Read[] =>
  path.length ? list.filter(e => e.id === path[0]).flatMap(e => (path.length === 1 ? [e] : find(e.children, ...path.slice(1)))) : [];
const whole = ({data}: Read) => data.reduce((sum, byte) => 256 * sum + byte, 0);

const video = (count: number, frameDuration: number): Video => ({codec: 'V_VP8', width: 640, height: 480, frameDuration, colours: {matrix: 'bt709', transfer: 'iec61966-2-1', primaries: 'bt709', fullRange: true},
                                                                 frames: Array.from({length: count}, (_, i) => ({data: Uint8Array.of(7, i % 256), key: i === 0}))});

test('a WebM file has its frames at equal times, and lasts one period', () => {
  const file = elements(webm(video(60, 33))), [segment] = find(file, 0x18538067);
  assert.equal(new TextDecoder().decode(find(file, 0x1a45dfa3, 0x4282)[0]!.data), 'webm');
  assert.equal(whole(find(segment!.children, 0x1549a966, 0x2ad7b1)[0]!), 1e6);
  const duration = find(segment!.children, 0x1549a966, 0x4489)[0]!.data;
  assert.equal(new DataView(duration.buffer, duration.byteOffset).getFloat64(0), 1980);
  const track = find(segment!.children, 0x1654ae6b, 0xae)[0]!.children;
  assert.equal(new TextDecoder().decode(find(track, 0x86)[0]!.data), 'V_VP8');
  assert.deepEqual([0xb0, 0xba].map(id => whole(find(track, 0xe0, id)[0]!)), [640, 480]);
  assert.deepEqual([0x55b1, 0x55b9, 0x55ba, 0x55bb].map(id => whole(find(track, 0xe0, 0x55b0, id)[0]!)), [1, 2, 13, 1]);  // full range, sRGB
  assert.equal(whole(find(track, 0x23e383)[0]!), 33e6);
  assert.deepEqual(times(segment!), Array.from({length: 60}, (_, i) => 33 * i));
});
test('a slow video has more than one cluster, because times within one have 16 bits', () => {
  const [segment] = find(elements(webm(video(300, 200))), 0x18538067);
  assert.equal(find(segment!.children, 0x1f43b675).length, 2);
  assert.deepEqual(times(segment!), Array.from({length: 300}, (_, i) => 200 * i));
});
test('frames are about 30 a second, a whole number of milliseconds apart', () => {
  assert.deepEqual(framesOf(2), {count: 60, frameDuration: 33});
  assert.deepEqual(framesOf(0.5), {count: 24, frameDuration: 21});
  assert.deepEqual(framesOf(10), {count: 300, frameDuration: 33});
});

function times(segment: Read): number[] {
  return find(segment.children, 0x1f43b675).flatMap(cluster => {
    const begin = whole(find(cluster.children, 0xe7)[0]!);
    return find(cluster.children, 0xa3).map(({data}) => {
      assert.equal(data[0], 0x81);  // of track 1
      return begin + new DataView(data.buffer, data.byteOffset).getInt16(1);
    });
  });
}
