// SPDX-License-Identifier: BSD-3-Clause
import {webm, type EncodedFrame, type Video} from './webm.ts';

/// Frames of a video of one period that lasts `seconds`: equally spaced, about 30 a second, and as many as the first
/// period needs to join the next one without a jump.
export function framesOf(seconds: number): {count: number; frameDuration: number} {
  const count = Math.max(24, Math.round(30 * seconds));
  return {count, frameDuration: Math.max(1, Math.round(1000 * seconds / count))};
}
export const canRecord = () => typeof VideoEncoder !== 'undefined';

const CODECS = [{codec: 'vp8', name: 'V_VP8'}, {codec: 'vp09.00.41.08', name: 'V_VP9'}] as const;  // the quicker one first

/// A video of one period of a drawing. @param draw  draws the phase i/count of the period into the canvas, at once
export async function periodVideo(canvas: HTMLCanvasElement, seconds: number, draw: (share: number) => void): Promise<Uint8Array> {
  const {count, frameDuration} = framesOf(seconds), even = (size: number) => size - size % 2;  // VP8 and VP9 halve the colours
  draw(0);
  const [width, height] = [even(canvas.width), even(canvas.height)];
  const settings = {width, height, framerate: 1000 / frameDuration, bitrate: Math.max(2e6, 0.15 * width * height * 1000 / frameDuration)};
  const chosen = await firstSupported(settings);
  if (!chosen) throw new Error('This browser encodes neither VP8 nor VP9.');
  const frames: EncodedFrame[] = [];
  let failure: DOMException | null = null, colours: VideoColorSpaceInit = {};
  const encoder = new VideoEncoder({
    output: (chunk, metadata) => {
      colours = metadata?.decoderConfig?.colorSpace ?? colours;
      const data = new Uint8Array(chunk.byteLength);
      chunk.copyTo(data);
      frames.push({data, key: chunk.type === 'key'});
    },
    error: error => { failure = error; },
  });
  encoder.configure({...settings, codec: chosen.codec});
  for (let i = 0; i < count && !failure; i++) {
    draw(i / count);
    const frame = new VideoFrame(canvas, {timestamp: 1000 * i * frameDuration, duration: 1000 * frameDuration, alpha: 'discard', visibleRect: {x: 0, y: 0, width, height}});
    encoder.encode(frame, {keyFrame: i === 0});
    frame.close();
    while (encoder.encodeQueueSize > 2) await new Promise(resolve => setTimeout(resolve, 4));  // the page stays alive
  }
  if (!failure) await encoder.flush();
  if (failure) throw failure;
  encoder.close();
  const video: Video = {codec: chosen.name, width, height, frameDuration, frames, colours};
  return webm(video);
}
async function firstSupported(settings: Omit<VideoEncoderConfig, 'codec'>) {
  for (const one of CODECS) if ((await VideoEncoder.isConfigSupported({...settings, codec: one.codec})).supported) return one;
  return null;
}
