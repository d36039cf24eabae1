ARG BASE=python:3.13-slim-trixie@sha256:7c61056e61ac89e852de05f3dc6fa51a6dd2181797bceed46aa725dd7cb2cd3b

# The packages, without what this app never reads; tools/cut.py says what each cut saves, 170 of 410 MB in all.
FROM ${BASE} AS packages
WORKDIR /build
COPY requirements.txt tools/cut.py ./
RUN pip install --no-cache-dir --no-compile --require-hashes --target /packages --requirement requirements.txt \
    && python cut.py /packages \
    && python -m compileall -q -j 0 /packages

FROM ${BASE}
# tini passes a stop on and waits for what the worker processes leave behind. Nothing is installed any more: no pip.
RUN apt-get update \
    && apt-get install --yes --no-install-recommends "tini=0.19.*" \
    && rm -rf /var/lib/apt/lists/* \
    && useradd --create-home --uid 1000 lecture \
    && pip uninstall --yes --root-user-action ignore pip
COPY --from=packages /packages /packages
WORKDIR /app
COPY app.py reading.py ./
COPY components components
COPY physics physics
COPY static static
# Nothing is written when it runs: what is compiled here is not compiled at each start.
RUN python -m compileall -q -j 0 app.py reading.py components physics
USER 1000

# The settings are environment variables; docs/deployment.md names them.
ENV ADDRESS=0.0.0.0 PORT=5006 LOG_FORMAT=json PYTHONPATH=/packages PYTHONDONTWRITEBYTECODE=1
EXPOSE 5006
# Container engines send visitors to healthy replicas and let an upgrade go on, so this asks whether the server is ready.
# It asks often, so that a replica counts as healthy soon; a start takes long on a busy machine.
HEALTHCHECK --interval=5s --timeout=5s --start-period=120s CMD ["python", "-ISc", "import os, socket; s = socket.create_connection(('127.0.0.1', int(os.environ['PORT'])), 4); s.sendall(b'GET /readiness HTTP/1.0\\r\\n\\r\\n'); assert b' 200 ' in s.recv(99)"]
ENTRYPOINT ["tini", "--"]
CMD ["python", "-m", "components.serving"]
