let compiled = null;
let session = null;

/** Does what the page asks for, and answers with the state: a picture of it for each request. */
const REQUESTS = {
  async compile({engine}) { compiled = await WebAssembly.compile(engine); },
  open({run, definition, settings}) {
    session = null;
    session = Object.assign(new Session(compiled, definition, settings), {run});
  },
  // There is no session where the last one could not be opened.
  order({order}) { session?.orderSoon(order); },
  advance({to, budget}) { session?.advance(to, budget); },
};

function answerWith(error) {
  const answer = {error};
  if (session) Object.assign(answer, {run: session.run, time: session.time, schedule: session.schedule, ...session.engine.read()});
  postMessage(answer, answer.disks ? [answer.disks.buffer] : []);
}

onmessage = async ({data}) => {
  try {
    await REQUESTS[data.request](data);
    answerWith(null);
  } catch (error) {
    answerWith(error.message);
  }
};
