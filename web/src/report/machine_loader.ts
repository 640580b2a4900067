// SPDX-License-Identifier: BSD-3-Clause
// The machine in 3D below its drawing. Its script and data are packed in the page; they are unpacked when a reader comes to it.
import type {show} from './machine_view.ts';

declare global {
  var trivetMachine: {show: typeof show} | undefined;
}

/// Without these two the page has the drawing alone.
const canUnpack = () => 'DecompressionStream' in globalThis;
function drawsInWebGL(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}

async function unpacked(id: string): Promise<string> {
  const bytes = Uint8Array.from(atob(document.getElementById(id)!.textContent!), character => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
}
/// Shows the machine. If that fails, its place goes, and the error is seen in the console of the browser.
async function startMachine(holder: HTMLElement) {
  try {
    await showMachine(holder);
  } catch (error) {
    holder.remove();
    throw error;
  }
}
/// As a script of the page: a module from a blob is not allowed for files in every browser.
async function showMachine(holder: HTMLElement) {
  const [program, data] = await Promise.all([unpacked('machine-script'), unpacked('machine-data')]);
  const script = document.createElement('script');
  script.textContent = program;
  document.head.append(script);
  holder.removeAttribute('aria-busy');
  globalThis.trivetMachine!.show(holder, JSON.parse(data));
}

/// Makes the place of the machine, which is filled when it comes into the window.
export function offerMachine() {
  const drawing = document.querySelector('.machine .drawing');
  if (!drawing || !document.getElementById('machine-data') || !canUnpack()) return;
  const holder = document.createElement('div');
  holder.className = 'machine-3d on-screen';
  holder.setAttribute('aria-busy', 'true');
  drawing.after(holder);
  const watcher = new IntersectionObserver(entries => {
    if (!entries.some(entry => entry.isIntersecting)) return;
    watcher.disconnect();
    if (drawsInWebGL()) void startMachine(holder);
    else holder.remove();
  });
  watcher.observe(holder);
}
