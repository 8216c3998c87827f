// Makes one file of a page: node scripts/web/one_file.js FOLDER OUT.html
// The program goes into the page compressed, as text; the browser unpacks it before it starts.
'use strict';
const fs = require('fs');
const path = require('path');
const zlib = require('zlib');

const [folder, out] = process.argv.slice(2);
const read = (name) => fs.readFileSync(path.join(folder, name));
const packed = zlib.gzipSync(read('replan.wasm'), { level: 9 }).toString('base64');
// A script element ends at the first "</script", wherever it stands.
const script = read('replan.js').toString().replaceAll('</script', '<\\/script');
const start = `
const tellOld = () => (document.getElementById('words').textContent =
  'This browser is too old for Replan. It takes one of 2023 or later: Chrome or Edge 95, Firefox 113, Safari 16.4.');
async function unpack() {
  const packed = document.getElementById('program').textContent;
  const bytes = Uint8Array.from(atob(packed), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
var Module = {};
unpack().then((bytes) => {
  Module.wasmBinary = bytes;
  const script = document.createElement('script');
  script.textContent = document.getElementById('glue').textContent;
  document.body.appendChild(script);
}, tellOld);
`;
const page = read('index.html')
  .toString()
  .replace(
    '<script src="replan.js"></script>',
    () =>
      `<script type="text/plain" id="program">${packed}</script>\n` +
      `<script type="text/plain" id="glue">${script}</script>\n<script>${start}</script>`,
  );
fs.writeFileSync(out + '.part', page);
fs.renameSync(out + '.part', out);
