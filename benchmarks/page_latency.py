# SPDX-License-Identifier: BSD-3-Clause
"""How long from the input of a slider to painted curves, in Chromium with software rendering?

    build/page/bin/python benchmarks/page_latency.py [PROJECT] [STEPS]      (scripts/page makes that environment)

Prints medians and 95th percentiles in ms: of one answer of the server to what a slider asks at each step, of an input until the frame with
its curves, and of the exact peaks after the last step; of a project with tolerances also how often its yield follows. The own script of the page
is CPU time, which does not depend on other programs.
The heap and the objects of WebGL before and after the steps must not grow. Without a project: one body, and ten.
"""
import http.client
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parents[1]
TRIVET = os.environ.get('TRIVET', str(ROOT / 'build/release/apps/cli/trivet'))

# A step begins at any time between two frames, as a hand does, and ends after the frame with its curves.
STEPS = """async steps => {
  const slider = document.querySelector('.sliders input[type=range]'), chart = document.querySelector('curve-chart'), {app} = chart, {asker, state} = app;
  const isDrawn = () => !asker.isOld('draft') || !asker.isOld('curves');
  const after = ms => new Promise(done => setTimeout(done, ms)), frame = () => new Promise(requestAnimationFrame);
  const when = is => new Promise(done => {
    if (is()) return done();
    const end = asker.subscribe(() => { if (is()) { end(); done(); } });
  });
  const times = [], begun = performance.now();
  let start = 0, samples = 0;
  const end = app.sampler?.subscribe(() => { samples++; });
  for (let i = 0; i < steps; i++) {
    await after(17 * ((i * 7) % 16) / 16);
    slider.value = String(350 + 300 * ((i * 37) % 101) / 101);
    start = performance.now();
    slider.dispatchEvent(new Event('input', {bubbles: true}));
    await when(isDrawn);
    await chart.updateComplete;
    await frame();
    await after(0);
    times.push(performance.now() - start);
  }
  const seconds = (performance.now() - begun) / 1000;
  end?.();
  await when(() => !asker.isOld('curves'));
  return {times, exact: performance.now() - start, samples: samples / seconds};
}"""
OBJECTS = """() => {
  globalThis.gc?.();
  const {memory, programs} = document.querySelector('machine-view').stage.renderer.info;
  return {heap: performance.memory.usedJSHeapSize, geometries: memory.geometries, textures: memory.textures, programs: programs.length};
}"""
SLIDER = """() => {
  const {app} = document.querySelector('curve-chart');
  return {settings: app.state.change.settings, drawn: app.display.drawn ?? [], bodies: app.asker.result('modes').bodies.length};
}"""


def spread(times):
    ordered = sorted(times)
    return f'median {statistics.median(ordered):.1f} ms, 95 % {ordered[int(0.95 * len(ordered))]:.1f} ms'


def answer_times(address, settings, drawn, bodies, count=200):
    """Of questions like those of a moving slider, by a client that does nothing else; and their size in bytes."""
    place, token = address.removeprefix('http://').split('/#token=')
    path, value = settings[0].split(' = ')
    number, *unit = value.strip('"').split()
    curves = {'command': 'curves', 'keys': {'draft': True, **({'of': drawn} if drawn else {})}}
    modes = {'command': 'modes', **({'keys': {'shapes-of': 1}} if bodies > 1 else {})}
    connection, times, size = http.client.HTTPConnection(place), [], 0
    for step in range(count):
        moved = f'{float(number) * (0.8 + 0.4 * (step * 37 % 101) / 101)!r} {" ".join(unit)}'.strip()
        setting = f'{path} = ' + (json.dumps(moved) if unit else moved)
        question = {
            'revision': step,
            'settings': [setting],
            'case': '',
            'wants': [{'command': 'scene'}, modes, curves],
        }
        headers = {
            'Content-Type': 'application/json',
            'X-Trivet-Token': token,
            'Origin': f'http://{place}',
            'Sec-Fetch-Site': 'same-origin',
        }
        start = time.perf_counter()
        connection.request('POST', '/ask', json.dumps(question), headers)
        body = connection.getresponse().read()
        times.append(1e3 * (time.perf_counter() - start))
        size = len(body)
        assert all(one['ok'] for one in json.loads(body)['results']), body[:300]
    return times, size


def measure(playwright, project, steps):
    server = subprocess.Popen(
        [TRIVET, 'serve', project, '--no-browser', '--read-only'], stdout=subprocess.PIPE, text=True
    )
    arguments = [
        '--enable-unsafe-swiftshader',
        '--no-sandbox',
        '--js-flags=--expose-gc',
        '--enable-precise-memory-info',
    ]
    browser = playwright.chromium.launch(executable_path='/usr/bin/chromium', args=arguments)
    page = browser.new_page(viewport={'width': 1280, 'height': 800}, reduced_motion='reduce')
    address = server.stdout.readline().strip()
    page.goto(address)
    page.wait_for_function("() => document.querySelector('.u-over') && !document.querySelector('.old')")
    print(f'{pathlib.Path(project).name}: {steps} steps')
    paint = page.evaluate("() => performance.getEntriesByName('first-contentful-paint')[0].startTime")
    print(f'  first paint                   {paint:.0f} ms')
    page.evaluate(STEPS, 30)
    session = page.context.new_cdp_session(page)
    session.send('Performance.enable', {'timeDomain': 'threadTicks'})

    def cpu():
        return {m['name']: m['value'] for m in session.send('Performance.getMetrics')['metrics']}

    page.wait_for_timeout(1000)  # what follows a rest
    before, cpu_before = page.evaluate(OBJECTS), cpu()
    found = page.evaluate(STEPS, steps)
    cpu_after = cpu()
    page.wait_for_timeout(1000)
    after = page.evaluate(OBJECTS)
    print(f'  input to painted curves       {spread(found["times"])}')
    print(f'  exact peaks after rest        {found["exact"]:.0f} ms')
    if found['samples'] > 0:
        print(f'  yields while it moves         {found["samples"]:.1f} a second')
    for name, what in (
        ('ScriptDuration', 'script'),
        ('LayoutDuration', 'layout'),
        ('RecalcStyleDuration', 'style'),
        ('TaskDuration', 'all tasks'),
    ):
        print(f'  {what + " of the page a step":30}{1e3 * (cpu_after[name] - cpu_before[name]) / steps:.2f} ms')
    for name in before:
        unit = 1e6 if name == 'heap' else 1
        print(
            f'  {name + (" [MB]" if name == "heap" else ""):30}{before[name] / unit:.4g} before, {after[name] / unit:.4g} after'
        )
    moved = page.evaluate(SLIDER)
    browser.close()
    times, size = answer_times(address, **moved)
    print(f'  one answer                    {spread(times)}, {size / 1e3:.1f} kB')
    server.terminate()
    server.wait()


def main():
    projects = (
        [sys.argv[1]]
        if len(sys.argv) > 1
        else [str(ROOT / 'examples/genset/genset.toml'), str(ROOT / 'benchmarks/ten_bodies.toml')]
    )
    with sync_playwright() as playwright:
        for project in projects:
            measure(playwright, project, int(sys.argv[2]) if len(sys.argv) > 2 else 300)


main()
