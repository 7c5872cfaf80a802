"use strict";
// What a library compiled for WASI preview 1 asks its host for: the file of its start values, and a
// place for messages. Names and numbers are those of the specification.
const WASI_OK = 0, WASI_BAD_FILE = 8, WASI_NO_ENTRY = 44;

// memory: called for the library's memory; files: contents by name; hear: called with what is printed
function wasi(memory, files, hear) {
  const ROOT = 3, ROOT_NAME = "/", DIRECTORY = 3, FILE = 4, FDSTAT_SIZE = 24;
  const open = new Map();
  const view = () => new DataView(memory().buffer);
  const bytes = (place, size) => new Uint8Array(memory().buffer, place, size);
  const text = (place, size) => new TextDecoder().decode(bytes(place, size).slice());
  // the parts of a vector of buffers
  const parts = (place, count) => Array.from({length: count}, (_, i) => [
    view().getUint32(place + 8 * i, true), view().getUint32(place + 8 * i + 4, true),
  ]);
  return {
    fd_prestat_get(fd, found) {
      if (fd !== ROOT) return WASI_BAD_FILE;
      view().setUint32(found, 0, true);
      view().setUint32(found + 4, ROOT_NAME.length, true);
      return WASI_OK;
    },
    fd_prestat_dir_name(fd, place, size) {
      bytes(place, size).set(new TextEncoder().encode(ROOT_NAME));
      return WASI_OK;
    },
    path_open(folder, flags, place, size, how, rights, inherited, status, found) {
      const content = files[text(place, size)];
      if (content === undefined) return WASI_NO_ENTRY;
      const fd = ROOT + 1 + open.size;
      open.set(fd, {content, at: 0});
      view().setUint32(found, fd, true);
      return WASI_OK;
    },
    fd_fdstat_get(fd, found) {
      bytes(found, FDSTAT_SIZE).fill(0);
      view().setUint8(found, fd === ROOT ? DIRECTORY : FILE);
      // all rights
      for (const place of [8, 16]) view().setBigUint64(found + place, ~0n & 0xffffffffffffffffn, true);
      return WASI_OK;
    },
    fd_fdstat_set_flags: () => WASI_OK,
    fd_read(fd, buffers, count, done) {
      const file = open.get(fd);
      if (!file) return WASI_BAD_FILE;
      let read = 0;
      for (const [place, size] of parts(buffers, count)) {
        const next = file.content.subarray(file.at, file.at + size);
        bytes(place, next.length).set(next);
        file.at += next.length;
        read += next.length;
      }
      view().setUint32(done, read, true);
      return WASI_OK;
    },
    fd_seek(fd, offset, whence, found) {
      const file = open.get(fd);
      if (!file) return WASI_BAD_FILE;
      file.at = [0, file.at, file.content.length][whence] + Number(offset);
      view().setBigUint64(found, BigInt(file.at), true);
      return WASI_OK;
    },
    fd_write(fd, buffers, count, done) {
      const told = parts(buffers, count);
      hear(told.map(([place, size]) => text(place, size)).join(""));
      view().setUint32(done, told.reduce((sum, [, size]) => sum + size, 0), true);
      return WASI_OK;
    },
    fd_close: (fd) => (open.delete(fd) ? WASI_OK : WASI_BAD_FILE),
    proc_exit(code) {
      throw new Error(`the library ended with code ${code}`);
    },
  };
}
