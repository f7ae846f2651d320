// Reads files by Khronos' glTF validator (tools/clients.py).
// Severities: 0 error, 1 warning, 2 information, 3 hint.
const fs = require("fs");
const validator = require("gltf-validator");

const text = ({code, message, pointer}) => `${code} ${message} ${pointer}`;

async function read(path) {
  const {info, issues} = await validator.validateBytes(new Uint8Array(fs.readFileSync(path)));
  const said = (least, most) =>
    issues.messages.filter(({severity}) => least <= severity && severity <= most).map(text).join("; ");
  return {triangles: info.totalTriangleCount, complaint: said(0, 1), remark: said(2, 3)};
}

(async () => {
  for (const [path] of JSON.parse(process.argv[process.argv.length - 1])) {
    const said = await read(path).catch(error => ({complaint: String(error)}));
    console.log("SAID " + JSON.stringify({path, ...said}));
  }
})();
