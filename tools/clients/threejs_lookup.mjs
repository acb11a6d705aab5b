// node threejs_lookup.mjs FOLDER: serves FOLDER (pictures, node_modules, threejs-request.json) to a headless Chromium, in which
// threejs_page.mjs asks three.js; prints what that sends back.

import { spawn } from 'node:child_process';
import { createServer } from 'node:http';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = process.argv[2];
const here = dirname(fileURLToPath(import.meta.url));
const page = `<!doctype html><script type="importmap">{"imports":{"three":"/node_modules/three/build/three.module.js",
"three/addons/":"/node_modules/three/examples/jsm/"}}</script><script type="module" src="/threejs_page.mjs"></script>`;
const types = { '.js': 'text/javascript', '.mjs': 'text/javascript', '.json': 'application/json' };
const profile = mkdtempSync(join(tmpdir(), 'skylut-clients-'));
let chromium;

function end(code, text) {
  (code === 0 ? process.stdout : process.stderr).write(`${text}\n`, () => {
    chromium.once('exit', () => {
      rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
      process.exit(code);
    });
    chromium.kill();
  });
}

const server = createServer((request, response) => {
  const path = normalize(new URL(request.url, 'http://localhost').pathname);
  if (request.method === 'POST') {
    let body = '';
    request.on('data', (part) => { body += part; });
    request.on('end', () => {
      response.end();
      end(path === '/answer' ? 0 : 1, body);
    });
    return;
  }
  try {
    const text = path === '/' ? page : readFileSync(join(path === '/threejs_page.mjs' ? here : folder, path));
    response.writeHead(200, { 'content-type': path === '/' ? 'text/html' : types[extname(path)] ?? 'application/octet-stream' });
    response.end(text);
  } catch {
    response.writeHead(404).end();
  }
});

server.listen(0, '127.0.0.1', () => {
  chromium = spawn('chromium', ['--headless=new', '--no-sandbox', '--no-first-run', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    `--user-data-dir=${profile}`, `http://127.0.0.1:${server.address().port}/`], { stdio: 'ignore' });
  setTimeout(() => end(1, 'no answer from Chromium within 8 minutes'), 480000).unref();
});
