# Debian 12 with the engine, Python and ROS: docker build -t ratchet_sieve . && docker run --rm -it ratchet_sieve
FROM debian:bookworm AS build
COPY . /ratchet_sieve
RUN /ratchet_sieve/scripts/package /packages

FROM debian:bookworm-slim
RUN --mount=type=bind,from=build,source=/packages,target=/packages \
    apt-get update && apt-get install -y /packages/*.deb && rm -rf /var/lib/apt/lists/*
ENV ROS_HOSTNAME=localhost
WORKDIR /root
CMD ["bash"]
