/** @param {unknown} room */
export async function openShare(room) {
  void room;
}
