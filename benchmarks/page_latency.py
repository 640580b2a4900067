# SPDX-License-Identifier: BSD-3-Clause
"""How long from the input of a slider to painted curves, in Chromium with software rendering?

    build/page/bin/python benchmarks/page_latency.py [PROJECT] [STEPS]      (scripts/page makes that environment)

Prints medians and 95th percentiles in ms, the objects of WebGL and the heap before and after: they must not grow.
"""
import os
import pathlib
import statistics
import subprocess
import sys

from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parents[1]
TRIVET = os.environ.get('TRIVET', str(ROOT / 'build/release/apps/cli/trivet'))

STEPS = """async steps => {
  const slider = document.querySelector('.sliders input[type=range]'), frame = () => new Promise(requestAnimationFrame), times = [];
  for (let i = 0; i < steps; i++) {
    slider.value = String(350 + 300 * ((i * 37) % 101) / 101);
    const start = performance.now();
    slider.dispatchEvent(new Event('input', {bubbles: true}));
    do await frame(); while (document.querySelector('curve-chart .old'));
    times.push(performance.now() - start);
  }
  return times;
}"""
HEAP = "() => { globalThis.gc?.(); return performance.memory.usedJSHeapSize; }"


def main():
    project = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / 'examples/genset/genset.toml')
    steps = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    words = [TRIVET, 'serve', project, '--no-browser', '--read-only']
    server = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
    with sync_playwright() as playwright:
        arguments = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox', '--js-flags=--expose-gc']
        browser = playwright.chromium.launch(executable_path='/usr/bin/chromium', args=arguments)
        page = browser.new_page(viewport={'width': 1280, 'height': 800}, reduced_motion='reduce')
        page.goto(server.stdout.readline().strip())
        page.wait_for_function("() => document.querySelector('.u-over') && !document.querySelector('.old')")
        paint = page.evaluate("() => performance.getEntriesByName('first-contentful-paint')[0].startTime")
        page.evaluate(STEPS, 20)
        before = page.evaluate(HEAP)
        times = sorted(page.evaluate(STEPS, steps))
        after = page.evaluate(HEAP)
        print(f'first paint {paint:.0f} ms')
        print(f'{steps} steps: median {statistics.median(times):.1f} ms, 95 % {times[int(0.95 * steps)]:.1f} ms')
        print(f'heap {before / 1e6:.1f} MB before, {after / 1e6:.1f} MB after')
        browser.close()
    server.terminate()
    server.wait()


main()
